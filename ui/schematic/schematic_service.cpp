#include "ui/schematic/schematic_service.h"

#include <algorithm>

namespace geargraph {
namespace {

/// Do both make the same drawing? Names, notes and the places of nodes do not matter.
bool sameDrawing(const Mechanism& a, const Mechanism& b) {
  const auto ids = [](const Link& x, const Link& y) { return x.id == y.id; };
  return std::equal(a.links.begin(), a.links.end(), b.links.begin(), b.links.end(), ids) &&
         a.axes == b.axes && a.turningJoints == b.turningJoints && a.gearMeshes == b.gearMeshes &&
         a.wheels == b.wheels && a.gearDefaults == b.gearDefaults && a.inputs == b.inputs &&
         a.couplings == b.couplings;
}

}  // namespace

SchematicService::SchematicService(QObject* parent)
    : QObject(parent),
      m_worker([this](const Request& request, const std::stop_token& stop) { draw(request, stop); }) {}

void SchematicService::request(const MechanismPtr& mechanism) {
  const bool same = m_mechanism && sameDrawing(*m_mechanism, *mechanism);
  m_mechanism = mechanism;
  if (same) return;
  ++m_wanted;
  m_worker.request({mechanism, m_wanted});
}

void SchematicService::draw(const Request& request, const std::stop_token& stop) {
  const auto schematic =
      std::make_shared<const SchematicGeometry>(schematicGeometry(*request.mechanism, stop));
  if (stop.stop_requested()) return;
  QMetaObject::invokeMethod(
      this, [this, schematic, number = request.number] { arrived(schematic, number); }, Qt::QueuedConnection);
}

void SchematicService::arrived(const SchematicPtr& schematic, quint64 number) {
  if (number != m_wanted) return;
  m_arrived = number;
  emit drawn(schematic);
}

}  // namespace geargraph
