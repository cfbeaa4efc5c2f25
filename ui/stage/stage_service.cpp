#include "ui/stage/stage_service.h"

#include <algorithm>
#include <utility>

#include "core/mechanism/model/difference.h"

namespace geargraph::inline ui_stage {
namespace {

/// Do both make the same stage?
bool sameStage(const Mechanism& a, const Mechanism& b) {
  const auto sameShapes = [](const Link& x, const Link& y) { return x.shapes == y.shapes; };
  return isSameTrain(a, b) &&
         std::equal(a.links.begin(), a.links.end(), b.links.begin(), b.links.end(), sameShapes);
}

}  // namespace

StageService::StageService(QObject* parent)
    : QObject(parent),
      m_worker([this](const Request& request, const std::stop_token& stop) { make(request, stop); }) {}

void StageService::setFolder(const std::filesystem::path& folder) {
  const std::lock_guard lock(m_mutex);
  if (std::exchange(m_folder, folder) != folder) m_mechanism.reset();  // its stage may be another there
}

void StageService::setPaintedByWindow(bool isPainted) {
  const std::lock_guard lock(m_mutex);
  m_isPaintedByWindow = isPainted;
}

quint64 StageService::wanted() const {
  const std::lock_guard lock(m_mutex);
  return m_wanted;
}

void StageService::request(const SnapshotPtr& snapshot) {
  const std::lock_guard lock(m_mutex);
  const bool same = m_mechanism && sameStage(*m_mechanism, *snapshot->mechanism);
  m_mechanism = snapshot->mechanism;
  if (same) return;
  ++m_wanted;
  m_worker.request({snapshot, m_wanted, m_folder, m_isPaintedByWindow});
}

void StageService::make(const Request& request, const std::stop_token& stop) {
  const ShapeSource shapes{m_shapes, request.folder, stop};
  m_memory.setFindsEdges(request.isPaintedByWindow);
  const StagePtr stage =
      trainStage(*request.snapshot, m_cache, request.folder.empty() ? nullptr : &shapes, &m_memory, stop);
  if (!stage) return;
  QMetaObject::invokeMethod(
      this, [this, stage, number = request.number] { arrived(stage, number); }, Qt::QueuedConnection);
}

void StageService::arrived(const StagePtr& stage, quint64 number) {
  if (number != wanted()) return;
  m_arrived = number;
  m_stage = stage;
  emit stageReady(stage);
}

}  // namespace geargraph::inline ui_stage
