#include "core/foundations/files/file_identity.h"

#include <system_error>

#include "core/foundations/platform/system.h"

namespace geargraph {

namespace fs = std::filesystem;

std::optional<FileIdentity> identityOf(const fs::path& path) {
  const auto stamp = fileStamp(path);
  if (!stamp || !stamp->numbers) return std::nullopt;
  return FileIdentity{stamp->numbers->device, stamp->numbers->inode};
}

fs::path followedLinks(fs::path path) {
  constexpr int kMaxChainLength = 40;  // the kernel's own limit
  std::error_code error;
  for (int i = 0; i < kMaxChainLength && fs::is_symlink(path, error); ++i) {
    const fs::path to = fs::read_symlink(path, error);
    if (error) break;
    path = to.is_absolute() ? to : path.parent_path() / to;
  }
  return path;
}

fs::path canonicalPath(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  if (error) return path;
  const fs::path canonical = fs::weakly_canonical(followedLinks(absolute), error);
  return error ? absolute.lexically_normal() : canonical;
}

bool isSameFile(const fs::path& a, const fs::path& b) {
  if (a.empty() || b.empty()) return false;
  const auto first = identityOf(a);
  const auto second = identityOf(b);
  if (first && second) return *first == *second;
  if (first || second) return false;
  std::error_code error;  // neither exists, or the system has no such numbers
  return fs::equivalent(a, b, error) || canonicalPath(a) == canonicalPath(b);
}

}  // namespace geargraph
