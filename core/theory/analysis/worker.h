#pragma once

#include "core/foundations/base/answer_worker.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

struct AnalysisRequest {
  DerivedGeometryPtr geometry;  ///< of the mechanism
  std::uint64_t revision = 0;
};

/// Analyses mechanisms on threads of its own, with analysisWork().
using AnalysisWorker = AnswerWorker<AnalysisRequest, SnapshotPtr>;

/// Answers each request twice: partly as soon as the live part is there, then with the complete snapshot,
/// which a background thread works out when requests no longer come one after the other.
[[nodiscard]] AnalysisWorker::Work analysisWork();

}  // namespace geargraph
