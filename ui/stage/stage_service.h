#pragma once

#include <filesystem>
#include <mutex>

#include "core/presentation/train_stage/train_stage.h"
#include "core/theory/analysis/analysis.h"
#include "ui/service/service.h"

namespace geargraph::inline ui_stage {

/// The input of a stage.
struct StageRequest {
  SnapshotPtr snapshot;
  std::filesystem::path folder;    ///< of the document; empty: the links' external 3D files are left out
  bool isPaintedByWindow = false;  ///< painted on the GUI thread: the stage has all data for painting
};

/// Makes the stages of the 3D view from snapshots on a background thread. Solids are cached between edits. A
/// request that does not change the stage (a node moved, a link renamed) is not computed again.
class StageService final : public Service<StageRequest, StagePtr> {
 public:
  explicit StageService(QObject* parent = nullptr);

  // For later requests. Thread-safe.
  void setFolder(const std::filesystem::path& folder);
  void setPaintedByWindow(bool isPainted);
  void requestStage(const SnapshotPtr& snapshot);

  [[nodiscard]] const StagePtr& stage() const { return answer(); }

 private:
  std::mutex m_mutex;
  StageRequest m_next;  ///< without the snapshot; guarded by m_mutex
};

}  // namespace geargraph::inline ui_stage
