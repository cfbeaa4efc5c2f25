#pragma once

#include <sys/stat.h>

#include <filesystem>

namespace geargraph::inline files {

/// Gives an open file the owner and group of another one, as far as the process may.
/// @return whether both are now those of `wanted`
[[nodiscard]] bool takeOwner(int descriptor, const struct stat& wanted);

/// Gives an open file the extended attributes of another one, access control lists among them, and takes
/// those away that it does not have (such as a list inherited from the folder). What the file system or the
/// permissions of the process do not allow is left out. Call it after the owner and the mode are set.
void takeExtendedAttributes(int descriptor, const std::filesystem::path& from);

}  // namespace geargraph::inline files
