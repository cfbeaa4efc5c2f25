#include "core/analysis/worker.h"

namespace geargraph {

AnalysisWorker::AnalysisWorker(Deliver deliver)
    : m_deliver(std::move(deliver)), m_thread([this](const std::stop_token& quit) { run(quit); }) {}

AnalysisWorker::~AnalysisWorker() {
  m_thread.request_stop();
  const std::lock_guard lock(m_mutex);
  m_running.request_stop();
}

void AnalysisWorker::request(MechanismPtr mechanism, std::uint64_t revision) {
  {
    const std::lock_guard lock(m_mutex);
    m_running.request_stop();
    m_next = Request{std::move(mechanism), revision, {}};
  }
  m_wake.notify_one();
}

void AnalysisWorker::run(const std::stop_token& quit) {
  while (true) {
    Request request;
    {
      std::unique_lock lock(m_mutex);
      if (!m_wake.wait(lock, quit, [this] { return m_next.has_value(); })) return;
      request = std::move(*m_next);
      m_next.reset();
      m_running = request.stop;
    }
    const auto deliver = [&](const SnapshotPtr& snapshot) {
      if (!snapshot || request.stop.stop_requested() || quit.stop_requested()) return false;
      m_deliver(snapshot);
      return true;
    };
    const std::stop_token stop = request.stop.get_token();
    const SnapshotPtr live = analyzeLive(std::move(request.mechanism), request.revision, stop);
    if (deliver(live)) deliver(analyzeFully(live, {}, stop));
  }
}

}  // namespace geargraph
