#pragma once

#include <string>
#include <string_view>

#include "core/teaching/derivation/glossary.h"

namespace geargraph {
struct Lesson;
}  // namespace geargraph

namespace geargraph {

/// The first lesson of the course that teaches the term; null if there is none.
[[nodiscard]] const Lesson* lessonAbout(Term term);
/// The picture for the term, as a name for manualPicture().
[[nodiscard]] std::string_view pictureOf(Term term);
/// The equation that defines the term, the paper's or the program's own, in TeX; empty if the glossary names
/// none.
[[nodiscard]] std::string formulaOfTerm(Term term);

/// The glossary as a page of the manual: every term by name, with definition, picture, equation and lesson.
[[nodiscard]] std::string glossaryMarkdown();
/// The course as a list of lessons with their goals.
[[nodiscard]] std::string courseMarkdown();

}  // namespace geargraph
