#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/foundations/files/file.h"

namespace geargraph {

/// Files by their paths within a folder ("meshes/link-1.stl"), in the order in which they are written.
using FolderFiles = std::vector<std::pair<std::string, std::string>>;

struct FolderOptions {
  bool overwrite = false;  ///< existing files
  std::stop_token stop;
  std::function<void(double)> progress;  ///< the fraction written, increasing to 1
};

/// Why a folder was not written; `isStopped`: because `stop` was requested.
struct FolderError {
  std::string message;
  bool isStopped = false;
};

/// Writes files into a folder. A new folder is built under a temporary name and renamed when complete, so it
/// is created atomically. In an existing one each file is written atomically; if a file exists and must not
/// be overwritten, nothing is written. std::nullopt on success.
[[nodiscard]] std::optional<FolderError> writeFolder(const std::filesystem::path& folder,
                                                     const FolderFiles& files,
                                                     const FolderOptions& options = {});

}  // namespace geargraph
