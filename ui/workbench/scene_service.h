#pragma once

#include <filesystem>
#include <mutex>

#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/theory/analysis/analysis.h"
#include "ui/service/service.h"

namespace geargraph {

/// The input of a stage.
struct SceneRequest {
  SnapshotPtr snapshot;
  std::filesystem::path folder;    ///< of the document; empty: the links' external 3D files are left out
  bool isPaintedByWindow = false;  ///< painted on the GUI thread: the stage has all data for painting
};

/// Makes the stages of the 3D view from snapshots on a background thread. Solids are cached between edits. A
/// request that does not change the stage (a node moved, a link renamed) is not computed again.
class SceneService final : public Service<SceneRequest, MechanismScenePtr> {
 public:
  explicit SceneService(QObject* parent = nullptr);

  // For later requests. Thread-safe.
  void setFolder(const std::filesystem::path& folder);
  void setPaintedByWindow(bool isPainted);
  void requestScene(const SnapshotPtr& snapshot);

  [[nodiscard]] const MechanismScenePtr& stage() const { return answer(); }

 private:
  std::mutex m_mutex;
  SceneRequest m_next;  ///< without the snapshot; guarded by m_mutex
};

}  // namespace geargraph
