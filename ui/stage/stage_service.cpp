#include "ui/stage/stage_service.h"

#include <algorithm>

#include "core/mechanism/model/difference.h"

namespace geargraph::inline ui_stage {
namespace {

bool isSameStage(const StageRequest& before, const StageRequest& now) {
  const Mechanism& a = *before.snapshot->mechanism;
  const Mechanism& b = *now.snapshot->mechanism;
  const auto sameShapes = [](const Link& x, const Link& y) { return x.shapes == y.shapes; };
  return before.folder == now.folder && isSameTrain(a, b) &&
         std::equal(a.links.begin(), a.links.end(), b.links.begin(), b.links.end(), sameShapes);
}

/// Makes stages one after the other, and what is kept from one to the next.
class StageMaker {
 public:
  void make(const StageRequest& request, const StageService::Responder& respond) {
    const ShapeSource shapes{m_shapes, request.folder, respond.stop()};
    m_memory.setFindsEdges(request.isPaintedByWindow);
    const StagePtr stage = trainStage(*request.snapshot, m_cache, request.folder.empty() ? nullptr : &shapes,
                                      &m_memory, respond.stop());
    if (stage) respond(stage);
  }

 private:
  GearCache m_cache{1024};  ///< four details a wheel, and the last edits'
  StageMemory m_memory;
  ShapeCache m_shapes;
};

StageService::Work stageWork() {
  return [maker = std::make_shared<StageMaker>()](const StageRequest& request,
                                                  const StageService::Responder& respond) {
    maker->make(request, respond);
  };
}

}  // namespace

StageService::StageService(QObject* parent) : Service(stageWork(), parent, {.same = &isSameStage}) {}

void StageService::setFolder(const std::filesystem::path& folder) {
  const std::lock_guard lock(m_mutex);
  m_next.folder = folder;
}

void StageService::setPaintedByWindow(bool isPainted) {
  const std::lock_guard lock(m_mutex);
  m_next.isPaintedByWindow = isPainted;
}

void StageService::requestStage(const SnapshotPtr& snapshot) {
  const std::lock_guard lock(m_mutex);
  StageRequest next = m_next;
  next.snapshot = snapshot;
  request(std::move(next));
}

}  // namespace geargraph::inline ui_stage
