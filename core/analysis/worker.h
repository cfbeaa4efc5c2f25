#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "core/analysis/analysis.h"

namespace geargraph {

/// Analyses mechanisms on one thread of its own; the newest request wins. A request that is overtaken is
/// stopped, and its snapshot is never delivered. Each request is answered twice: the live part as soon as it
/// is there, then the complete snapshot.
///
/// `deliver` is called on the worker's thread. It is not called again once the destructor has returned.
/// Free of Qt on purpose: the distribution's Qt is not built for the thread sanitizer, this is.
class AnalysisWorker {
 public:
  using Deliver = std::function<void(SnapshotPtr)>;

  explicit AnalysisWorker(Deliver deliver);
  ~AnalysisWorker();
  AnalysisWorker(const AnalysisWorker&) = delete;
  AnalysisWorker& operator=(const AnalysisWorker&) = delete;

  void request(MechanismPtr mechanism, std::uint64_t revision);

 private:
  struct Request {
    MechanismPtr mechanism;
    std::uint64_t revision = 0;
    std::stop_source stop;
  };

  void run(const std::stop_token& quit);

  Deliver m_deliver;
  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::optional<Request> m_next;  ///< guarded by m_mutex
  std::stop_source m_running;     ///< guarded by m_mutex: stops the analysis under way
  std::jthread m_thread;          ///< last: it starts when all else is there
};

}  // namespace geargraph
