#include "ui/stage/stage_service.h"

namespace geargraph {
namespace {

/// Do both make the same stage? Names, notes and the places of nodes do not matter.
bool sameStage(const Mechanism& a, const Mechanism& b) {
  // What links wear is among the members that the mechanism does not know.
  const auto ids = [](const Link& x, const Link& y) { return x.id == y.id && x.unknown == y.unknown; };
  return std::equal(a.links.begin(), a.links.end(), b.links.begin(), b.links.end(), ids) &&
         a.axes == b.axes && a.turningJoints == b.turningJoints && a.gearMeshes == b.gearMeshes &&
         a.wheels == b.wheels && a.gearDefaults == b.gearDefaults && a.inputs == b.inputs;
}

}  // namespace

StageService::StageService(QObject* parent)
    : QObject(parent),
      m_worker([this](const Request& request, const std::stop_token& stop) { make(request, stop); }) {}

void StageService::request(const SnapshotPtr& snapshot, const std::filesystem::path& folder) {
  const bool same = m_mechanism && m_folder == folder && sameStage(*m_mechanism, *snapshot->mechanism);
  m_folder = folder;
  m_mechanism = snapshot->mechanism;
  if (same) return;
  ++m_wanted;
  m_worker.request({snapshot, m_wanted, folder});
}

void StageService::make(const Request& request, const std::stop_token& stop) {
  const ShapeSource shapes{m_shapes, request.folder, stop};
  const StagePtr stage = trainStage(*request.snapshot, m_cache, request.folder.empty() ? nullptr : &shapes);
  QMetaObject::invokeMethod(
      this, [this, stage, number = request.number] { arrived(stage, number); }, Qt::QueuedConnection);
}

void StageService::arrived(const StagePtr& stage, quint64 number) {
  if (number != m_wanted) return;
  m_arrived = number;
  m_stage = stage;
  emit stageReady(stage);
}

}  // namespace geargraph
