#pragma once

#include <span>

#include "core/theory/statics/statics_report.h"

namespace geargraph {

/// The diagnostics of a solved report that concern the document: without notes on assumptions that the
/// document does not contain (unit-load, no-efficiency). Empty for a document without loads.
[[nodiscard]] Diagnostics solvedLoadDiagnostics(const Mechanism& mechanism, const StaticsReport& report);

/// The same for the states of a gearbox with nothing engaged, whose loads act in its states: the errors and
/// warnings, equal ones merged with the names of their states. `byState`: by position in the document, null
/// where nothing was solved.
[[nodiscard]] Diagnostics solvedLoadDiagnostics(const Mechanism& mechanism,
                                                std::span<const StaticsReport* const> byState);

}  // namespace geargraph
