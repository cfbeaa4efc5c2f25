#pragma once

#include <filesystem>
#include <mutex>

#include "core/presentation/train_stage/train_stage.h"
#include "core/theory/analysis/analysis.h"
#include "ui/service/service.h"

namespace geargraph::inline ui_stage {

/// What a stage is made of.
struct StageRequest {
  SnapshotPtr snapshot;
  std::filesystem::path folder;  ///< of the document; empty: the 3D files that links wear are left out
  bool isPaintedByWindow =
      false;  ///< by the window's own thread: the stage brings all that painting asks for
};

/// Makes the stages of the 3D view from snapshots. Solids are kept from one edit to the next. A request that
/// changes nothing of the stage (a node moved, a link renamed) is answered already.
class StageService final : public Service<StageRequest, StagePtr> {
 public:
  explicit StageService(QObject* parent = nullptr);

  // Of the requests to come; from any thread.
  void setFolder(const std::filesystem::path& folder);
  void setPaintedByWindow(bool isPainted);
  void requestStage(const SnapshotPtr& snapshot);

  [[nodiscard]] const StagePtr& stage() const { return answer(); }

 private:
  std::mutex m_mutex;
  StageRequest m_next;  ///< but for the snapshot; guarded by m_mutex
};

}  // namespace geargraph::inline ui_stage
