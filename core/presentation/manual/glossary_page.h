#pragma once

#include <string>
#include <string_view>

#include "core/teaching/derivation/glossary.h"

namespace geargraph::inline lessons {
struct Lesson;
}  // namespace geargraph::inline lessons

namespace geargraph::inline manual {

/// The first lesson of the course that teaches the term; null: none does.
[[nodiscard]] const Lesson* lessonAbout(Term term);
/// What shows the term, as manualPicture() reads it.
[[nodiscard]] std::string_view pictureOf(Term term);
/// The paper's equation that defines the term, or what the program computes by it, in TeX; empty where the
/// glossary names no equation.
[[nodiscard]] std::string formulaOfTerm(Term term);

/// The glossary as a page of the manual: every term by name, with definition, picture, equation and lesson.
[[nodiscard]] std::string glossaryMarkdown();
/// The course as a list of lessons with their goals.
[[nodiscard]] std::string courseMarkdown();

}  // namespace geargraph::inline manual
