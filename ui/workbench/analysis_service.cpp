#include "ui/workbench/analysis_service.h"

namespace geargraph {
namespace {

bool isSameRevision(const AnalysisRequest& before, const AnalysisRequest& now) {
  return before.revision == now.revision;
}

}  // namespace

AnalysisService::AnalysisService(QObject* parent, std::function<void(const SnapshotPtr&)> ahead)
    : Service(analysisWork(), parent, {.same = &isSameRevision, .ahead = std::move(ahead)}) {}

}  // namespace geargraph
