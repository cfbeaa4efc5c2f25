#include "core/foundations/files/folder.h"

#include <system_error>

#include "core/foundations/base/translation.h"
#include "core/foundations/platform/system.h"

namespace geargraph {
namespace {

namespace fs = std::filesystem;

FolderError notMade(const fs::path& folder, const std::string& why) {
  return {translated("The folder \"%1\" could not be made: %2.", {folder.string(), why})};
}

std::optional<FolderError> writeInto(const fs::path& folder, const FolderFiles& files,
                                     const FolderOptions& options) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (options.stop.stop_requested())
      return FolderError{translated("Stopped; the folder is not complete."), true};
    const fs::path path = folder / files[i].first;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) return notMade(path.parent_path(), error.message());
    if (const auto failure = writeFile(path, files[i].second)) return FolderError{failure->message};
    if (options.progress) options.progress(static_cast<double>(i + 1) / static_cast<double>(files.size()));
  }
  return std::nullopt;
}

/// Makes the folder under another name beside its place, which it takes when it is complete.
std::optional<FolderError> writeNew(const fs::path& folder, const FolderFiles& files,
                                    const FolderOptions& options) {
  const fs::path place = folder.has_filename() ? folder : folder.parent_path();
  const fs::path temporary =
      place.parent_path() / ("." + place.filename().string() + "." + std::to_string(processId()) + ".tmp");
  std::error_code error;
  if (place.has_parent_path()) fs::create_directories(place.parent_path(), error);
  if (!error) fs::create_directory(temporary, error);
  if (error) return notMade(folder, error.message());
  auto failure = writeInto(temporary, files, options);
  if (!failure) {
    fs::rename(temporary, place, error);
    if (error) failure = notMade(folder, error.message());
  }
  if (failure) fs::remove_all(temporary, error);
  return failure;
}

}  // namespace

std::optional<FolderError> writeFolder(const fs::path& folder, const FolderFiles& files,
                                       const FolderOptions& options) {
  std::error_code error;
  if (!fs::exists(folder, error)) return writeNew(folder, files, options);
  if (!fs::is_directory(folder, error)) return notMade(folder, translated("there is a file of that name"));
  for (const auto& [name, bytes] : files) {
    if (!options.overwrite && fs::exists(folder / name, error))
      return FolderError{
          translated("\"%1\" is there already; nothing was written.", {(folder / name).string()})};
  }
  return writeInto(folder, files, options);
}

}  // namespace geargraph
