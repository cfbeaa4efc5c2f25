#include "core/theory/analysis/worker.h"

namespace geargraph {
namespace {

/// A snapshot to be completed, and who waits for it.
struct LivePart {
  SnapshotPtr snapshot;
  AnalysisWorker::Responder respond;
};

void complete(const LivePart& live) {
  live.respond.guard([&] {
    if (SnapshotPtr whole = analyzeFully(live.snapshot, {}, live.respond.stop())) live.respond(whole);
  });
}

}  // namespace

AnalysisWorker::Work analysisWork() {
  const auto completion = std::make_shared<RequestWorker<LivePart>>(
      [](const LivePart& live, const std::stop_token&) { complete(live); }, Urgency::background);
  return [completion](const AnalysisRequest& request, const AnalysisWorker::Responder& respond) {
    const SnapshotPtr live = analyzeLive(request.geometry, request.revision, respond.stop());
    if (!live || respond.stop().stop_requested()) return;
    respond.partly(live);
    completion->request({live, respond});
  };
}

}  // namespace geargraph
