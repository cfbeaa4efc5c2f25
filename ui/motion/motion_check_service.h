#pragma once

#include <memory>

#include "core/design/collision/motion_findings.h"
#include "ui/service/service.h"

namespace geargraph::inline ui_motion {

/// Null where there is nothing to check: errors, no motion, too many links, axes without places.
using MotionReportPtr = std::shared_ptr<const MotionReport>;

/// Checks the motion of mechanisms for collisions, on a background thread and only when edits no longer come
/// one after the other. A request that changes nothing of the train is answered already.
class MotionCheckService final : public Service<SnapshotPtr, MotionReportPtr> {
 public:
  explicit MotionCheckService(QObject* parent = nullptr);

  /// The report on another train is void at once: the answer is null until the new one arrives.
  void requestCheck(const SnapshotPtr& snapshot);
  [[nodiscard]] const MotionReportPtr& report() const { return answer(); }
};

}  // namespace geargraph::inline ui_motion
