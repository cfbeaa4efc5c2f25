#pragma once

#include "core/foundations/files/byte_sink.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {

/// Matrices of more entries than this are written as triplets, unless `dense` is asked for.
constexpr long long kMostEntries = 250'000;

/// The analysis as JSON (`analyze --json`). Parts that are not defined are null: all but the diagnostics
/// where the file could not be read and there is no snapshot.
void writeAnalysisJson(ByteSink& sink, const AnalysisSnapshot* snapshot, const Diagnostics& diagnostics,
                       bool dense);

}  // namespace geargraph::cli
