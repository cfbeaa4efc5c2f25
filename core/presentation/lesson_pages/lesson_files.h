#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/foundations/files/folder.h"
#include "core/teaching/lessons/prepared_step.h"

namespace geargraph {

/// A page for browsers, or a package for learning platforms.
enum class LessonFileForm { html, scorm };

[[nodiscard]] std::optional<LessonFileForm> lessonFileForm(std::string_view name);  ///< "scorm"

/// The names of the files of lessons: "index.html", which lists them, and by lesson "gear-pair.html" and
/// "gear-pair.zip".
[[nodiscard]] std::vector<std::string> lessonFileNames(std::span<const Lesson> lessons,
                                                       std::span<const LessonFileForm> forms);

/// The files. The result is meaningless if `stop` was requested. Fails as lessonHtml(), and with
/// `duplicate-id` where two lessons have one id. Cost: that of lessonHtml() for each lesson and form.
[[nodiscard]] Expected<FolderFiles> lessonFiles(std::span<const Lesson> lessons,
                                                std::span<const LessonFileForm> forms,
                                                const ExampleSource& examples,
                                                const std::stop_token& stop = {});

}  // namespace geargraph
