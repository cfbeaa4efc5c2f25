#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/result_json/lost_motion_report.h"
#include "core/presentation/result_json/vibration_report.h"
#include "ui/service/service.h"

namespace geargraph {

struct VibrationRequest {
  SnapshotPtr snapshot;
  VibrationOptions options;
  bool wantsLostMotion = false;  ///< it takes longer than frequencies
};

/// What repeats in the window's document, and how far its outputs can turn by the play of its teeth.
struct VibrationAnswer {
  SnapshotPtr snapshot;
  VibrationOptions options;
  std::vector<FrequencyCase> cases;
  std::optional<std::vector<LostMotionCase>> lostMotion;  ///< where it was asked for
};
using VibrationPtr = std::shared_ptr<const VibrationAnswer>;

/// Computes frequencies and lost motion on a background thread, while a view shows them.
class VibrationService final : public Service<VibrationRequest, VibrationPtr> {
 public:
  explicit VibrationService(QObject* parent = nullptr);
};

}  // namespace geargraph
