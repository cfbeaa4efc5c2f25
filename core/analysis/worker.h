#pragma once

#include <functional>

#include "core/analysis/analysis.h"
#include "core/base/request_worker.h"

namespace geargraph {

/// Analyses mechanisms on one thread of its own; the newest request wins. A request that is overtaken is
/// stopped, and its snapshot is never delivered. Each request is answered twice: the live part as soon as it
/// is there, then the complete snapshot.
///
/// `deliver` is called on the worker's thread. It is not called again once the destructor has returned.
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

  void answer(Request request, const std::stop_token& stop);

  Deliver m_deliver;
  RequestWorker<Request> m_worker;  ///< last: it is stopped before what it uses goes
};

}  // namespace geargraph
