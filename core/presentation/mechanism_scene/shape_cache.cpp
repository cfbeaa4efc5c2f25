#include "core/presentation/mechanism_scene/shape_cache.h"

#include <algorithm>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kMaxKept = 64;

Solid scaled(Solid solid, double scale) {
  for (Float3& point : solid.positions) {
    for (float& coordinate : point) coordinate = static_cast<float>(coordinate * scale);
  }
  return solid;
}

/// Without symbolic links, which an archive may bring along; empty where the file is not in the folder.
fs::path fileInside(const fs::path& folder, const std::string& name) {
  std::error_code error;
  const fs::path root = fs::weakly_canonical(folder, error);
  const fs::path file = error ? fs::path() : fs::weakly_canonical(folder / name, error);
  if (error) return {};
  const auto [inRoot, inFile] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
  return inRoot == root.end() && inFile != file.end() ? file : fs::path();
}

}  // namespace

std::variant<std::shared_ptr<const Solid>, std::string> ShapeCache::find(const fs::path& folder,
                                                                         const std::string& name,
                                                                         double scale,
                                                                         const std::stop_token& stop) {
  const fs::path file = fileInside(folder, name);
  if (file.empty()) return translated("It is not in the folder of the document: copy it there.");
  std::error_code error;
  Key key{file.string(), 0, 0, scale};
  key.size = fs::is_regular_file(file, error) ? fs::file_size(file, error) : 0;
  const auto changed = fs::last_write_time(file, error);
  if (!error) key.changed = changed.time_since_epoch().count();
  if (const auto known = m_known.find(key); known != m_known.end() && !error) return known->second;
  auto read = readForeignMesh(m_reader, file, m_limits, stop);
  Found found;
  if (auto* solid = std::get_if<Solid>(&read)) {
    found = std::make_shared<const Solid>(scaled(std::move(*solid), scale));
  } else {
    const auto& why = std::get<MeshFileError>(read);
    found = why.message;
    if (why.kind == MeshFileError::Kind::stopped) return found;
  }
  if (m_known.size() >= kMaxKept) m_known.clear();
  return m_known[key] = std::move(found);
}

}  // namespace geargraph
