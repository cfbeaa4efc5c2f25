#pragma once

#include <QString>
#include <string>

#include "ui/derivation/derivation_service.h"

namespace geargraph::inline ui_lessons {

/// The text of a step with its formula, and its task, set like a page of the derivation. What is no TeX that
/// can be set is shown as it is written.
[[nodiscard]] SetReportPtr stepText(const std::string& title, const std::string& text,
                                    const std::string& formula, const std::string& equation,
                                    const std::string& task, const std::string& prompt,
                                    const std::string& taskFormula);

/// A sentence without formulas for a label: dollar signs go, TeX stays.
[[nodiscard]] QString plainSentence(const std::string& sentence);

}  // namespace geargraph::inline ui_lessons
