#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/foundations/files/folder.h"
#include "core/teaching/exercises/exercise_sheet.h"

namespace geargraph {

/// A sheet and its solution as a document, or with the train as a page for browsers that grades what is
/// filled in, by itself or as a package for learning platforms.
enum class SheetFileForm : std::uint8_t { html, latex, pdf, json, handout, scorm };

[[nodiscard]] std::optional<SheetFileForm> sheetFileForm(std::string_view name);  ///< "latex"

/// The options of an exercise sheet's files.
struct SheetRequest {
  SheetPlan plan;
  std::vector<std::string> students;  ///< by variant, printed on the sheets; may be empty
  std::vector<SheetFileForm> forms;
  std::filesystem::path folder = {};  ///< of the document, with the attached 3D files that handouts show
};

/// The names of all files of a sheet, relative to its folder: "sheet.json", and by variant "answers-07.json",
/// "sheet-07.pdf", "solution-07.pdf", "handout-07.html", "scorm-07.zip"; with handouts or packages
/// "index.html".
[[nodiscard]] std::vector<std::string> sheetFileNames(const SheetRequest& request);

/// The files of a sheet: the sheet itself, from which the program can reproduce everything, and for each
/// variant the questions and the solution in every form and a file for the answers; a handout or a package is
/// one file, and a page that lists these by variant and student comes with them. `progress` is called with
/// the number of finished variants. The result is meaningless if `stop` was requested meanwhile. Cost:
/// variants · forms documents. Errors: `graphics` where a handout would be too large.
/// @pre the source supports every kind of the plan; students.size() is 0 or plan.variants
[[nodiscard]] Expected<FolderFiles> sheetFiles(const ExerciseSource& source, const SheetRequest& request,
                                               const std::function<void(int variants)>& progress = {},
                                               const std::stop_token& stop = {});

}  // namespace geargraph
