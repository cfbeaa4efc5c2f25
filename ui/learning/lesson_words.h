#pragma once

#include <QString>
#include <string>

#include "core/mechanism/graph/paper_equation.h"
#include "ui/reading/derivation_service.h"

namespace geargraph {

/// The typeset text of a step with its formula and its task. TeX that cannot be parsed is shown literally.
[[nodiscard]] SetReportPtr stepText(const std::string& title, const std::string& text,
                                    const std::string& formula, PaperEquation equation,
                                    const std::string& task, const std::string& prompt,
                                    const std::string& taskFormula);

/// A sentence for a plain label: without dollar signs, with TeX unchanged.
[[nodiscard]] QString plainSentence(const std::string& sentence);

}  // namespace geargraph
