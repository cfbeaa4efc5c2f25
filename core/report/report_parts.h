#pragma once

#include "core/report/report.h"

namespace geargraph {

// The parts of a report, each as far as the snapshot goes.

/// The mechanism itself, its digraph and the matrices of whole numbers, Eqs. (1)-(5).
void addDigraphPart(Report& report, const AnalysisSnapshot& snapshot);
/// Screws, P and the solution, Eqs. (6)-(25).
void addMatroidPart(Report& report, const SnapshotPtr& snapshot);
/// Carriers, terminal and f-circuit equations, the chain of substitutions, Eqs. (26)-(45).
void addTtGraphPart(Report& report, const AnalysisSnapshot& snapshot);

}  // namespace geargraph
