#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace geargraph::cli {

/// A place for a folder that a served command writes and whose files become a part of its answer; nothing of
/// it is left at the end.
class ServedFolder {
 public:
  ServedFolder();
  ~ServedFolder();
  ServedFolder(const ServedFolder&) = delete;
  ServedFolder& operator=(const ServedFolder&) = delete;

  /// Could the place be made?
  [[nodiscard]] bool isMade() const { return !m_place.empty(); }
  /// Where the command writes: a folder that does not exist yet. @pre isMade()
  [[nodiscard]] std::string path() const { return (m_place / "files").string(); }
  /// The files that were written, by their paths within the folder with slashes, in the order of the paths;
  /// std::nullopt if there is no folder, or a file cannot be read or is over 256 MiB.
  [[nodiscard]] std::optional<std::vector<std::pair<std::string, std::string>>> files() const;

 private:
  std::filesystem::path m_place;
};

/// Do these options of `export` ask for a folder?
[[nodiscard]] bool asksForFolder(const std::vector<std::string>& words);

}  // namespace geargraph::cli
