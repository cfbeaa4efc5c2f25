#include "core/foundations/files/overwrite.h"

#include <string>

namespace geargraph {

Overwritten overwriteInPlace(const std::filesystem::path& target, OpenFile& source) {
  std::error_code error;
  OpenFile file(target, OpenMode::change, error);
  if (error) return {error, true};
  const std::string fresh = source.contents(error);
  if (error) return {error, true};
  const std::string old = file.contents(error);
  if (error) return {error, true};
  std::error_code undone;
  if (fresh.size() > old.size()) {
    file.reserve(old.size(), fresh.size(), error);
    if (error) {
      file.truncate(old.size(), undone);
      return {error, !undone};
    }
  }
  file.setContents(fresh, error);
  if (!error) return {};
  file.setContents(old, undone);
  return {error, !undone};
}

}  // namespace geargraph
