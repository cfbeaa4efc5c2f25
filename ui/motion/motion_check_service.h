#pragma once

#include <QObject>
#include <memory>

#include "core/design/collision/motion_findings.h"
#include "core/foundations/base/request_worker.h"

namespace geargraph::inline ui_motion {

/// Null where there is nothing to check: errors, no motion, too many links.
using MotionReportPtr = std::shared_ptr<const MotionReport>;

/// Checks the motion of mechanisms for collisions, on a background thread and only when edits no longer come
/// one after the other; the newest request wins, and a stale report never arrives.
class MotionCheckService : public QObject {
  Q_OBJECT

 public:
  explicit MotionCheckService(QObject* parent = nullptr);

  /// Another mechanism than the last one's: its report is void at once (reportReady(nullptr)), and a new one
  /// follows, if the document places all of its axes. A request that changes nothing of the train is answered
  /// by the report there is.
  void request(const SnapshotPtr& snapshot);
  [[nodiscard]] const MotionReportPtr& report() const { return m_report; }
  /// Has the newest request been answered?
  [[nodiscard]] bool isUpToDate() const { return m_arrived == m_wanted; }

 signals:
  void reportReady(const geargraph::MotionReportPtr& report);

 private:
  struct Request {
    SnapshotPtr snapshot;
    quint64 number = 0;
  };

  void check(const Request& request, const std::stop_token& stop);
  void arrived(const MotionReportPtr& report, quint64 number);

  quint64 m_wanted = 0;
  quint64 m_arrived = 0;
  MechanismPtr m_mechanism;  ///< of the newest request
  MotionReportPtr m_report;
  RequestWorker<Request> m_worker;  ///< last: it is stopped before what it uses goes
};

}  // namespace geargraph::inline ui_motion
