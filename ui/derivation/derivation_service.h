#pragma once

#include <QObject>
#include <memory>

#include "core/foundations/base/request_worker.h"
#include "core/presentation/pages/flow.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::inline ui_derivation {

using SetReportPtr = std::shared_ptr<const SetReport>;

/// Works out and sets derivations on a thread of its own; the newest request wins.
class DerivationService : public QObject {
  Q_OBJECT

 public:
  explicit DerivationService(QObject* parent = nullptr);

  /// @pre the snapshot is complete and of no more than kMostReportLinks links
  void request(const SnapshotPtr& snapshot);

 signals:
  /// Of the newest request.
  void ready(const geargraph::SetReportPtr& report);

 private:
  struct Request {
    SnapshotPtr snapshot;
    quint64 number = 0;
  };
  void make(const Request& request, const std::stop_token& stop);

  quint64 m_wanted = 0;
  RequestWorker<Request> m_worker;  ///< last: it is stopped before what it uses goes
};

}  // namespace geargraph::inline ui_derivation
