#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <variant>

#include "core/presentation/meshfile/foreign_mesh.h"

namespace geargraph {

/// A cache of the attached 3D files of links; a file is read again when it changes on disk. Errors are cached
/// too. Not thread-safe.
class ShapeCache {
 public:
  explicit ShapeCache(std::filesystem::path reader = foreignMeshReader(), const ForeignLimits& limits = {})
      : m_reader(std::move(reader)), m_limits(limits) {}

  /// The solid of `folder` / `file`, scaled by `scale`; or the reason why there is none, as a sentence. A
  /// symbolic link that leads out of the folder is not followed.
  [[nodiscard]] std::variant<std::shared_ptr<const Solid>, std::string> find(
      const std::filesystem::path& folder, const std::string& file, double scale,
      const std::stop_token& stop);

 private:
  struct Key {
    std::string path;
    std::int64_t changed = 0;
    std::uintmax_t size = 0;
    double scale = 1;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  using Found = std::variant<std::shared_ptr<const Solid>, std::string>;

  std::filesystem::path m_reader;
  ForeignLimits m_limits;
  std::map<Key, Found> m_known;
};

/// Where a document's attached 3D files are read from.
struct ShapeSource {
  ShapeCache& cache;
  std::filesystem::path folder;  ///< of the document
  std::stop_token stop = {};
};

}  // namespace geargraph
