#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/foundations/files/file.h"

namespace geargraph::inline files {

/// Files by their paths within a folder ("meshes/link-1.stl"), in the order in which they are written.
using FolderFiles = std::vector<std::pair<std::string, std::string>>;

struct FolderOptions {
  bool overwrite = false;  ///< files that are there already
  std::stop_token stop;
  std::function<void(double)> progress;  ///< the part that is written, growing to 1
};

/// Why a folder was not written; `isStopped`: because `stop` was requested.
struct FolderError {
  std::string message;
  bool isStopped = false;
};

/// Writes files into a folder. A folder that is not there is made beside its place and takes it when it is
/// complete, so it is there whole or not at all. Into one that is there each file is written whole; where a
/// file is in the way and may not be overwritten nothing is written.
[[nodiscard]] std::optional<FolderError> writeFolder(const std::filesystem::path& folder,
                                                     const FolderFiles& files,
                                                     const FolderOptions& options = {});

}  // namespace geargraph::inline files
