// `manual -o FOLDER`: the manual of the program as web pages.

#include <array>
#include <filesystem>
#include <set>

#include "app/cli/command.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/presentation/manual/manual_site.h"

namespace geargraph::cli {
namespace {

namespace fs = std::filesystem;

/// "robot" for pictures/window-robot-light.png with its dark twin.
std::set<std::string> windowPicturesIn(const fs::path& folder) {
  static constexpr std::string_view kStart = "window-";
  static constexpr std::string_view kEnd = "-light.png";
  std::set<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / "pictures", error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(kStart) || !name.ends_with(kEnd)) continue;
    const std::string inside = name.substr(kStart.size(), name.size() - kStart.size() - kEnd.size());
    if (fs::exists(folder / "pictures" / ("window-" + inside + "-dark.png"), error)) names.insert(inside);
  }
  return names;
}

int runManual(const Arguments& arguments) {
  const auto path = arguments.value("-o");
  if (!path || *path == "-") return wrongUsage(kManual, translated("It needs -o with a folder."));
  if (!arguments.files.empty()) return wrongUsage(kManual, translated("It reads no file."));
  const fs::path folder = *path;
  std::error_code error;
  fs::create_directories(folder / "pictures", error);
  if (!fs::is_directory(folder / "pictures"))
    return fileFailure(translated("The folder \"%1\" could not be made.", {(folder / "pictures").string()}));
  const std::vector<ManualFile> files = manualSite(windowPicturesIn(folder));
  if (!arguments.has("--force")) {
    for (const ManualFile& file : files) {
      if (fs::exists(folder / file.name, error))
        return fileFailure(
            translated("\"%1\" is there already; --force overwrites it.", {(folder / file.name).string()}));
    }
  }
  for (const ManualFile& file : files)
    if (const auto why = writeFile(folder / file.name, file.bytes)) return fileFailure(why->message);
  return print(translated("%1 files in %2", {std::to_string(files.size()), folder.string()}) + '\n');
}

constexpr std::array kManualOptions = {
    Option{"-o", "FOLDER", toTranslate("the folder that the pages are written to")},
    Option{"--force", "", toTranslate("overwrite files that are there")}};

}  // namespace

const Command kManual = {
    .name = "manual",
    .usage = "-o FOLDER [--force]",
    .summary = toTranslate("Writes the manual of the program as web pages, with its pictures."),
    .options = kManualOptions,
    .run = runManual,
    .isServed = false};

}  // namespace geargraph::cli
