#pragma once

#include "core/foundations/files/byte_sink.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// Matrices of more entries than this are written as triplets, unless `dense` is asked for.
constexpr long long kMaxEntries = 250'000;

struct AnalysisJsonOptions {
  bool dense = false;    ///< all entries, of matrices of any size
  bool matrices = true;  ///< false: without the members "matrices" and "cycles"
};

/// The analysis as JSON (`analyze --json`). Undefined parts are null; without a snapshot (the file could not
/// be read) all but the diagnostics.
void writeAnalysisJson(ByteSink& sink, const SnapshotPtr& snapshot, const Diagnostics& diagnostics,
                       const AnalysisJsonOptions& options = {});

}  // namespace geargraph
