#pragma once

#include <string>

#include "core/foundations/base/expected.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/report/report.h"

namespace geargraph::inline pages {

/// The drawings of a report; empty ones are left out.
struct ReportLists {
  DisplayList schematic;
  DisplayList digraph;
  DisplayList ttGraph;

  [[nodiscard]] const DisplayList& of(ReportDrawing drawing) const;
};

/// A report on pages of A4, to print and to read: formulas and drawings stay lines and text, headings are in
/// the outline. No heading stands at a page's foot. Matrices shrink where they are too wide, at most to six
/// tenths. Fails with `graphics` where memory does not suffice. Cost: linear in the report.
[[nodiscard]] Expected<std::string> reportPdf(Report report, const ReportLists& drawings);

}  // namespace geargraph::inline pages
