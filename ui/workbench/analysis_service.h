#pragma once

#include "core/theory/analysis/worker.h"
#include "ui/service/service.h"

namespace geargraph {

/// Analyses the window's document: every request is answered twice, by the live part and by the complete
/// snapshot.
class AnalysisService final : public Service<AnalysisRequest, SnapshotPtr> {
 public:
  /// `ahead`: ServiceOptions::ahead
  explicit AnalysisService(QObject* parent = nullptr, std::function<void(const SnapshotPtr&)> ahead = {});

  /// The newest snapshot received; null before the first.
  [[nodiscard]] const SnapshotPtr& snapshot() const { return answer(); }
};

}  // namespace geargraph
