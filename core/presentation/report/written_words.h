#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/mechanism/graph/paper_equation.h"
#include "core/presentation/report/report.h"

namespace geargraph {

/// A sentence of an author, with formulas between dollar signs. What the program cannot set, and all of it
/// where a dollar sign is missing, is shown as it is written.
[[nodiscard]] ReportWords writtenWords(std::string_view sentence);

/// Adds an author's formula on a line of its own with the number of the paper; as words where it cannot be
/// set, nothing where it is empty.
void addWrittenFormula(std::vector<ReportBlock>& blocks, const std::string& tex, PaperEquation equation);

}  // namespace geargraph
