#include "core/machine/measure/measure_spots.h"

#include <cmath>
#include <limits>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/train_wheels.h"
#include "core/mechanism/kinds/pair_kind.h"

namespace geargraph {
namespace {

Vector3 narrow(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// The pitch circle's plane on the axis, seen from the frame's origin.
double middleOf(const GearSpec& spec) {
  return isConical(spec) ? coneDistance(spec) * std::cos(spec.coneAngle) : 0;
}

}  // namespace

Rational squareFromLine(const ExactVector3& point, const ExactLine& line) {
  const ExactVector3 across = cross(point - line.point, line.direction);
  return dot(across, across) / dot(line.direction, line.direction);
}

MeasureSpots::MeasureSpots(DerivedGeometryPtr geometry) : m_geometry(std::move(geometry)) {
  const Placement& placement = m_geometry->placement();
  if (!placement.tree || !placement.classes) return;
  addAxes();
  addMeshes();
  addWheels();
}

void MeasureSpots::addAxes() {
  const Mechanism& mechanism = m_geometry->mechanism();
  const Placement& placement = m_geometry->placement();
  for (const AxisGroupOrdinal axisGroup : placement.classes->classes.ordinals()) {
    const AxisOrdinal axis = placement.classes->classes[axisGroup].axis;
    m_ofClass.push_back(m_spots.size());
    m_spots.push_back({.kind = Spot::Kind::axis,
                       .element = mechanism.axes[static_cast<std::size_t>(int{axis})].id,
                       .point = placement.axes[axis].point,
                       .line = exactLineOfClass(mechanism, placement, axisGroup),
                       .direction = placement.axes[axis].direction});
  }
}

void MeasureSpots::addMeshes() {
  const Mechanism& mechanism = m_geometry->mechanism();
  const Placement& placement = m_geometry->placement();
  for (const MeshOrdinal mesh : placement.meshes.ordinals()) {
    const std::optional<MeshGeometry>& geometry = placement.meshes[mesh];
    if (!geometry) continue;
    Spot spot{.kind = Spot::Kind::pitchPoint,
              .element = mechanism.gearMeshes[static_cast<std::size_t>(int{mesh})].id,
              .point = geometry->pitchPoint,
              .exactPoint = exactPitchPoint(mechanism, placement, mesh)};
    const auto add = [&](LinkOrdinal link, AxisGroupOrdinal axisGroup, double radius) {
      spot.meshLines.push_back(exactLineOfClass(mechanism, placement, axisGroup));
      if (!touches(geometry->kind)) return;
      MeasuredWheel wheel{.link = link, .mesh = mesh, .pitchDiameter = 2 * radius};
      if (spot.exactPoint)
        wheel.pitchSquare = Rational(4) * squareFromLine(*spot.exactPoint, spot.meshLines.back());
      spot.meshWheels.push_back(wheel);
    };
    add(geometry->tail, geometry->tailClass, geometry->tailPitchRadius());
    add(geometry->head, geometry->headClass, geometry->headPitchRadius());
    m_spots.push_back(std::move(spot));
  }
}

void MeasureSpots::addWheels() {
  const Mechanism& mechanism = m_geometry->mechanism();
  const std::shared_ptr<const TrainWheels> wheels = m_geometry->wheels();
  if (wheels == nullptr) return;
  for (const TrainWheel& wheel : wheels->wheels) {
    const MeshOrdinal first = wheel.meshes.front();
    const GearMesh& mesh = mechanism.gearMeshes[static_cast<std::size_t>(int{first})];
    const Spot axis = m_spots[m_ofClass[wheel.axisGroup]];  // the list grows meanwhile
    MeasuredWheel sizes{.link = wheel.link,
                        .mesh = first,
                        .tipDiameter = 2 * nominalTipRadius(wheel.spec),
                        .rootDiameter = 2 * nominalRootRadius(wheel.spec),
                        .faceWidth = wheel.spec.faceWidth};
    for (const Spot& spot : m_spots) {
      if (spot.element != ElementId(mesh.id) || spot.meshWheels.size() != 2) continue;
      const MeasuredWheel& pitch = spot.meshWheels[spot.meshWheels[0].link == wheel.link ? 0 : 1];
      sizes.pitchDiameter = pitch.pitchDiameter;
      sizes.pitchSquare = pitch.pitchSquare;
    }
    const auto add = [&](Spot::Kind kind, double along) {
      m_spots.push_back({.kind = kind,
                         .element = mechanism.links[static_cast<std::size_t>(int{wheel.link})].id,
                         .point = narrow(wheel.origin + along * wheel.axis),
                         .line = axis.line,
                         .direction = axis.direction,
                         .wheel = sizes});
    };
    add(Spot::Kind::wheelCentre, middleOf(wheel.spec));
    if (isConical(wheel.spec)) continue;  // its end faces are cones
    add(Spot::Kind::faceCentre, -wheel.spec.faceWidth / 2);
    add(Spot::Kind::faceCentre, wheel.spec.faceWidth / 2);
  }
}

const Spot* MeasureSpots::of(const ElementId& element, const std::optional<Vector3>& near) const {
  const Mechanism& mechanism = m_geometry->mechanism();
  const Placement& placement = m_geometry->placement();
  if (m_spots.empty()) return nullptr;
  const auto ofClass = [&](AxisGroupOrdinal axisGroup) { return &m_spots[m_ofClass[axisGroup]]; };
  for (std::size_t i = 0; i < mechanism.turningJoints.size(); ++i) {
    const TurningJoint& joint = mechanism.turningJoints[i];
    if (ElementId(joint.id) == element || ElementId(joint.axis) == element)
      return ofClass(placement.classes->classOf[JointOrdinal(i)]);
  }
  const Spot* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Spot& spot : m_spots) {
    if (spot.element != element) continue;
    const double away = near ? length(spot.point - *near) : static_cast<double>(nearest != nullptr);
    if (away < least) nearest = &spot;
    least = std::min(least, away);
  }
  if (nearest != nullptr) return nearest;
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    const AxisGroupOrdinal axisGroup = placement.classes->ofLink[LinkOrdinal(i)];
    if (ElementId(mechanism.links[i].id) == element && axisGroup >= 0) return ofClass(axisGroup);
  }
  return nullptr;
}

std::string MeasureSpots::nameOf(const Spot& spot) const {
  const Mechanism& mechanism = m_geometry->mechanism();
  const std::string label = labelOf(mechanism, spot.element).value_or(std::string());
  const std::string mesh = spot.wheel ? std::to_string(mechanism.meshLabel(spot.wheel->mesh)) : std::string();
  switch (spot.kind) {
    case Spot::Kind::axis:
      return translated("axis %1", {label});
    case Spot::Kind::pitchPoint:
      return translated("pitch point of mesh %1", {label});
    case Spot::Kind::wheelCentre:
      return translated("centre of gear %1 in mesh %2", {label, mesh});
    case Spot::Kind::faceCentre:
      return translated("face of gear %1 in mesh %2", {label, mesh});
  }
  return {};
}

}  // namespace geargraph
