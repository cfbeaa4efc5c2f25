#include "ui/motion/motion_check_service.h"

#include <algorithm>
#include <utility>

#include "core/mechanism/model/difference.h"

namespace geargraph::inline ui_motion {
namespace {

/// Does the document place all axes? Of a bare graph the program chooses the places, so that a collision is
/// nothing that its author did.
bool isPlaced(const Mechanism& mechanism) {
  return std::all_of(mechanism.axes.begin(), mechanism.axes.end(),
                     [](const Axis& axis) { return axis.point && axis.direction; });
}

}  // namespace

MotionCheckService::MotionCheckService(QObject* parent)
    : QObject(parent),
      m_worker([this](const Request& request, const std::stop_token& stop) { check(request, stop); },
               Urgency::background) {}

void MotionCheckService::request(const SnapshotPtr& snapshot) {
  const bool same = m_mechanism && isSameTrain(*m_mechanism, *snapshot->mechanism);
  m_mechanism = snapshot->mechanism;
  if (same) return;
  ++m_wanted;
  if (isPlaced(*snapshot->mechanism)) {
    m_worker.request({snapshot, m_wanted});
  } else {
    m_arrived = m_wanted;
  }
  if (std::exchange(m_report, nullptr)) emit reportReady(nullptr);
}

void MotionCheckService::check(const Request& request, const std::stop_token& stop) {
  MotionReportPtr report;
  if (auto found = checkMotion(*request.snapshot, stop))
    report = std::make_shared<const MotionReport>(std::move(*found));
  QMetaObject::invokeMethod(
      this, [this, report, number = request.number] { arrived(report, number); }, Qt::QueuedConnection);
}

void MotionCheckService::arrived(const MotionReportPtr& report, quint64 number) {
  if (number != m_wanted) return;
  m_arrived = number;
  m_report = report;
  emit reportReady(report);
}

}  // namespace geargraph::inline ui_motion
