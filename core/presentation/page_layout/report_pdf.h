#pragma once

#include <string>

#include "core/foundations/base/expected.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/report/report.h"

namespace geargraph {

/// A report as an A4 PDF: formulas and drawings are vector graphics and text, headings are in the outline. No
/// page ends with a heading. Matrices that are too wide are scaled down, at most to 0.6. Fails with
/// `graphics` if memory is exhausted. Cost: linear in the report.
[[nodiscard]] Expected<std::string> reportPdf(Report report, const ReportLists& drawings);

}  // namespace geargraph
