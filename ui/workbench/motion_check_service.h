#pragma once

#include <memory>

#include "core/design/collision/motion_diagnostics.h"
#include "ui/service/service.h"

namespace geargraph {

/// Null if there is nothing to check: errors, no motion, too many links, or axes without places.
using MotionReportPtr = std::shared_ptr<const MotionReport>;

/// Checks the motion of mechanisms for collisions on a background thread, once edits have paused. A request
/// for an unchanged train is not computed again.
class MotionCheckService final : public Service<SnapshotPtr, MotionReportPtr> {
 public:
  explicit MotionCheckService(QObject* parent = nullptr);

  /// If the train has changed, the report is null until the new one arrives.
  void requestCheck(const SnapshotPtr& snapshot);
  [[nodiscard]] const MotionReportPtr& report() const { return answer(); }
};

}  // namespace geargraph
