#include "core/analysis/worker.h"

namespace geargraph {

AnalysisWorker::AnalysisWorker(Deliver deliver)
    : m_deliver(std::move(deliver)),
      m_worker([this](Request request, const std::stop_token& stop) { answer(std::move(request), stop); }) {}

void AnalysisWorker::request(MechanismPtr mechanism, std::uint64_t revision) {
  m_worker.request({std::move(mechanism), revision});
}

void AnalysisWorker::answer(Request request, const std::stop_token& stop) {
  const auto deliver = [&](const SnapshotPtr& snapshot) {
    if (!snapshot || stop.stop_requested()) return false;
    m_deliver(snapshot);
    return true;
  };
  const SnapshotPtr live = analyzeLive(std::move(request.mechanism), request.revision, stop);
  if (deliver(live)) deliver(analyzeFully(live, {}, stop));
}

}  // namespace geargraph
