#include "core/foundations/files/file_attributes.h"

#include <sys/xattr.h>
#include <unistd.h>

#include <set>
#include <string>

namespace geargraph::inline files {
namespace {

/// The names of a list in which each ends with a zero byte.
std::set<std::string> namesIn(const std::string& list) {
  std::set<std::string> names;
  for (std::size_t at = 0; at < list.size();) {
    names.insert(list.c_str() + at);
    at = list.find('\0', at) + 1;
    if (at == 0) break;
  }
  return names;
}

/// Calls a function of the kernel that fills a buffer: first for the size, then for the bytes. Empty if it
/// fails.
template <class Fill>
std::string filled(const Fill& fill) {
  const ssize_t wanted = fill(nullptr, 0);
  if (wanted <= 0) return {};
  std::string bytes(static_cast<std::size_t>(wanted), '\0');
  const ssize_t size = fill(bytes.data(), bytes.size());
  bytes.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return bytes;
}

}  // namespace

bool takeOwner(int descriptor, const struct stat& wanted) {
  if (::fchown(descriptor, wanted.st_uid, wanted.st_gid) == 0) return true;
  // A group that the process belongs to may be given without the right to give files away.
  const int onlyGroup = ::fchown(descriptor, static_cast<uid_t>(-1), wanted.st_gid);
  struct stat now {};
  return onlyGroup == 0 && ::fstat(descriptor, &now) == 0 && now.st_uid == wanted.st_uid;
}

void takeExtendedAttributes(int descriptor, const std::filesystem::path& from) {
  const auto wanted =
      namesIn(filled([&](char* to, std::size_t size) { return ::listxattr(from.c_str(), to, size); }));
  const auto inherited =
      namesIn(filled([&](char* to, std::size_t size) { return ::flistxattr(descriptor, to, size); }));
  for (const std::string& name : inherited) {
    if (!wanted.contains(name)) ::fremovexattr(descriptor, name.c_str());
  }
  for (const std::string& name : wanted) {
    const std::string value =
        filled([&](char* to, std::size_t size) { return ::getxattr(from.c_str(), name.c_str(), to, size); });
    ::fsetxattr(descriptor, name.c_str(), value.data(), value.size(), 0);
  }
}

}  // namespace geargraph::inline files
