#pragma once

#include <functional>
#include <mutex>

#include "core/foundations/base/request_worker.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::inline analysis {

/// Analyses mechanisms on threads of its own; the newest request wins. A request that is overtaken is
/// stopped, and its snapshot is never delivered. Each request is answered twice: the live part as soon as it
/// is there, then the complete snapshot, which is worked for when requests no longer come one after the
/// other.
///
/// `deliver` is called on the worker's threads, never on two at once. It is not called again once the
/// destructor has returned.
class AnalysisWorker {
 public:
  using Deliver = std::function<void(SnapshotPtr)>;

  explicit AnalysisWorker(Deliver deliver);

  void request(MechanismPtr mechanism, std::uint64_t revision);

 private:
  struct Request {
    MechanismPtr mechanism;
    std::uint64_t revision = 0;
  };

  /// A snapshot, and whether a newer request has overtaken it.
  struct Step {
    SnapshotPtr snapshot;
    std::stop_token overtaken;
  };

  void answer(Request request, const std::stop_token& overtaken);
  void complete(const Step& live);
  /// False where there is nothing to deliver, or no more.
  bool deliver(const Step& step);

  Deliver m_deliver;
  std::mutex m_delivering;
  RequestWorker<Step> m_second;    ///< behind what it uses: it is stopped before that goes
  RequestWorker<Request> m_first;  ///< behind the second, which it sets to work
};

}  // namespace geargraph::inline analysis
