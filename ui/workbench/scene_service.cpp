#include "ui/workbench/scene_service.h"

#include <algorithm>

#include "core/mechanism/model/difference.h"

namespace geargraph {
namespace {

bool isSameStage(const SceneRequest& before, const SceneRequest& now) {
  const Mechanism& a = *before.snapshot->mechanism;
  const Mechanism& b = *now.snapshot->mechanism;
  const auto sameShapes = [](const Link& x, const Link& y) { return x.shapes == y.shapes; };
  return before.folder == now.folder && isSameTrain(a, b) &&
         std::equal(a.links.begin(), a.links.end(), b.links.begin(), b.links.end(), sameShapes);
}

/// Makes stages one after the other, and what is kept from one to the next.
class StageMaker {
 public:
  void make(const SceneRequest& request, const SceneService::Responder& respond) {
    const ShapeSource shapes{m_shapes, request.folder, respond.stop()};
    m_memory.setFindsEdges(request.isPaintedByWindow);
    const MechanismScenePtr stage = mechanismScene(
        *request.snapshot, m_cache, request.folder.empty() ? nullptr : &shapes, &m_memory, respond.stop());
    if (stage) respond(stage);
  }

 private:
  GearCache m_cache{1024};  ///< four details a wheel, and the last edits'
  SceneMemory m_memory;
  ShapeCache m_shapes;
};

SceneService::Work stageWork() {
  return [maker = std::make_shared<StageMaker>()](const SceneRequest& request,
                                                  const SceneService::Responder& respond) {
    maker->make(request, respond);
  };
}

}  // namespace

SceneService::SceneService(QObject* parent) : Service(stageWork(), parent, {.same = &isSameStage}) {}

void SceneService::setFolder(const std::filesystem::path& folder) {
  const std::lock_guard lock(m_mutex);
  m_next.folder = folder;
}

void SceneService::setPaintedByWindow(bool isPainted) {
  const std::lock_guard lock(m_mutex);
  m_next.isPaintedByWindow = isPainted;
}

void SceneService::requestScene(const SnapshotPtr& snapshot) {
  const std::lock_guard lock(m_mutex);
  SceneRequest next = m_next;
  next.snapshot = snapshot;
  request(std::move(next));
}

}  // namespace geargraph
