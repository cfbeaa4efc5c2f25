#pragma once

#include <span>

#include "core/theory/statics/statics_report.h"

namespace geargraph::inline statics {

/// What of a solved report belongs among the findings of its document: without remarks on what was solved
/// beside the document (unit-load, no-efficiency). None for a document without loads.
[[nodiscard]] Diagnostics loadFindings(const Mechanism& mechanism, const StaticsReport& report);

/// The same of the states of a gearbox that has nothing engaged, where loads are meant for its states: the
/// errors and warnings, equal ones once with the names of their states. `byState`: by position in the
/// document, null where nothing was solved.
[[nodiscard]] Diagnostics loadFindings(const Mechanism& mechanism,
                                       std::span<const StaticsReport* const> byState);

}  // namespace geargraph::inline statics
