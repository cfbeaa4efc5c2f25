#include "ui/workbench/motion_check_service.h"

#include <algorithm>

#include "core/mechanism/model/difference.h"

namespace geargraph {
namespace {

/// Does the document place all axes? Of a bare graph the program chooses the places, so that a collision is
/// nothing that its author did.
bool isPlaced(const Mechanism& mechanism) {
  return std::all_of(mechanism.axes.begin(), mechanism.axes.end(),
                     [](const Axis& axis) { return axis.point && axis.direction; });
}

bool isSameMotion(const SnapshotPtr& before, const SnapshotPtr& now) {
  return isSameTrain(*before->mechanism, *now->mechanism);
}

void check(const SnapshotPtr& snapshot, const MotionCheckService::Responder& respond) {
  if (!isPlaced(*snapshot->mechanism)) return respond(nullptr);
  auto found = checkMotion(*snapshot, respond.stop());
  respond(found ? std::make_shared<const MotionReport>(std::move(*found)) : nullptr);
}

}  // namespace

MotionCheckService::MotionCheckService(QObject* parent)
    : Service(&check, parent, {.urgency = Urgency::background, .same = &isSameMotion}) {}

void MotionCheckService::requestCheck(const SnapshotPtr& snapshot) {
  if (request(snapshot) && report()) setAnswer(nullptr);
}

}  // namespace geargraph
