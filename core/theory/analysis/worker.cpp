#include "core/theory/analysis/worker.h"

namespace geargraph::inline analysis {

AnalysisWorker::AnalysisWorker(Deliver deliver)
    : m_deliver(std::move(deliver)),
      m_second([this](const Step& step, const std::stop_token&) { complete(step); }, Urgency::background),
      m_first([this](Request request, const std::stop_token& stop) { answer(std::move(request), stop); }) {}

void AnalysisWorker::request(MechanismPtr mechanism, std::uint64_t revision) {
  m_first.request({std::move(mechanism), revision});
}

bool AnalysisWorker::deliver(const Step& step) {
  const std::lock_guard lock(m_delivering);
  if (!step.snapshot || step.overtaken.stop_requested()) return false;
  m_deliver(step.snapshot);
  return true;
}

void AnalysisWorker::answer(Request request, const std::stop_token& overtaken) {
  const Step live{analyzeLive(std::move(request.mechanism), request.revision, overtaken), overtaken};
  if (deliver(live)) m_second.request(live);
}

void AnalysisWorker::complete(const Step& live) {
  deliver({analyzeFully(live.snapshot, {}, live.overtaken), live.overtaken});
}

}  // namespace geargraph::inline analysis
