#include "core/machine/train/train_wheels.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/pair_wheels.h"
#include "core/machine/train/wheel_sharing.h"
#include "core/mechanism/placement/hypoid.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

/// Coordinates that are meant to be equal differ by the rounding of decimals at most.
bool same(double a, double b, double scale) {
  return std::abs(a - b) <= 1e-6 * scale;
}

/// How far operating radii of one wheel may differ between its meshes: profile shifts make up for no more.
constexpr double kSameWheel = 0.12;

struct WheelSide {
  LinkOrdinal link;
  AxisGroupOrdinal axisGroup;
  int teeth;
  double radius;
  std::optional<WheelId> named;
};

class WheelFinder {
 public:
  WheelFinder(const Mechanism& mechanism, const Placement& placement)
      : m_mechanism(mechanism),
        m_placement(placement),
        m_sharing(mechanism, placement),
        m_ofLink(mechanism.links.size()) {}

  TrainWheels find(const std::stop_token& stop) {
    for (int m = 0; m < m_mechanism.c() && !stop.stop_requested(); ++m) {
      const auto& geometry = m_placement.meshes[m];
      if (geometry && !pairWheels()[geometry->kind].none) addPair(m, *geometry);
    }
    return std::move(m_train);
  }

 private:
  void addPair(MeshOrdinal mesh, const MeshGeometry& geometry);
  [[nodiscard]] TrainWheel parallelWheel(const WheelSide& side, const MeshGeometry& geometry,
                                         GearKind kind) const;
  [[nodiscard]] TrainWheel pulley(const WheelSide& side, const MeshGeometry& geometry,
                                  int partnerTeeth) const;
  [[nodiscard]] TrainWheel crossedWheel(const WheelSide& side, const WheelSide& partner,
                                        const MeshGeometry& geometry) const;
  void bevelWheels(const WheelSide& tail, const WheelSide& head, const MeshGeometry& geometry, TrainWheel& a,
                   TrainWheel& b) const;
  [[nodiscard]] TrainWheel faceGear(const WheelSide& side, const MeshGeometry& geometry,
                                    int pinionTeeth) const;
  void offsetWheels(const WheelSide& tail, const WheelSide& head, const MeshGeometry& geometry, TrainWheel& a,
                    TrainWheel& b) const;
  void setHelices(const GearMesh& drawn, const MeshGeometry& geometry, TrainWheel& a, TrainWheel& b) const;
  void compare(GearOrdinal wheel, const TrainWheel& with, MeshOrdinal mesh);
  [[nodiscard]] std::vector<GearOrdinal> like(const TrainWheel& wheel) const;
  int add(TrainWheel wheel, std::optional<int> known, MeshOrdinal mesh);
  [[nodiscard]] static bool isSame(const TrainWheel& a, const TrainWheel& b);

  const Mechanism& m_mechanism;
  const Placement& m_placement;
  WheelSharing m_sharing;
  TrainWheels m_train;
  ByLink<std::vector<GearOrdinal>> m_ofLink;  ///< wheels
};

void WheelFinder::addPair(MeshOrdinal mesh, const MeshGeometry& geometry) {
  const GearMesh& drawn = m_mechanism.gearMeshes[mesh];
  const WheelSide tail{geometry.tail, geometry.tailClass, drawn.tailTeeth, geometry.tailPitchRadius(),
                       drawn.tailWheel};
  const WheelSide head{geometry.head, geometry.headClass, drawn.headTeeth, geometry.headPitchRadius(),
                       drawn.headWheel};
  TrainPair pair;
  pair.mesh = mesh;
  pair.kind = geometry.kind;
  pair.pitchPoint = wide(geometry.pitchPoint);
  pair.movable = geometry.derived && pairKind(geometry.kind).axes == LinePosition::parallel;
  TrainWheel a;
  TrainWheel b;
  if (pairKind(geometry.kind).hasFace) {
    const auto wheelAt = [&](const WheelSide& side, const WheelSide& partner) {
      if (side.teeth > partner.teeth) return faceGear(side, geometry, partner.teeth);
      TrainWheel pinion = parallelWheel(side, geometry, wheelOf(geometry.kind, side.teeth, partner.teeth));
      pinion.spec.module = 2 * side.radius / side.teeth;
      return pinion;
    };
    a = wheelAt(tail, head);
    b = wheelAt(head, tail);
  } else if (pairKind(geometry.kind).isOffset) {
    pair.normal = wide(geometry.normal);
    offsetWheels(tail, head, geometry, a, b);
  } else if (hasIntersectingAxes(geometry.kind)) {
    bevelWheels(tail, head, geometry, a, b);
  } else if (hasSkewAxes(geometry.kind)) {
    pair.distance = tail.radius + head.radius;
    pair.normal = wide(geometry.normal);
    a = crossedWheel(tail, head, geometry);
    b = crossedWheel(head, tail, geometry);
  } else if (!touches(geometry.kind)) {
    pair.distance =
        wide(geometry.tailToHead).cross(wide(m_placement.lineOfClass(tail.axisGroup).direction)).norm();
    a = pulley(tail, geometry, head.teeth);
    b = pulley(head, geometry, tail.teeth);
  } else {
    pair.distance = pairKind(geometry.kind).distance(tail.radius, head.radius);
    a = parallelWheel(tail, geometry, wheelOf(geometry.kind, tail.teeth, head.teeth));
    b = parallelWheel(head, geometry, wheelOf(geometry.kind, head.teeth, tail.teeth));
  }
  setHelices(drawn, geometry, a, b);
  a.id = tail.named;
  b.id = head.named;
  const std::vector<GearOrdinal> tails = like(a), heads = like(b);
  const auto first = [](const std::vector<GearOrdinal>& known) {
    return known.empty() ? std::nullopt : std::optional(known.front());
  };
  WheelSharing::Choice known{first(tails), first(heads)};
  const bool isGeared = touches(geometry.kind);
  if (isGeared && pair.movable && !a.id && !b.id) known = m_sharing.choose(a, tails, b, heads);
  pair.tail = add(a, known.tail, mesh);
  pair.head = add(b, known.head, mesh);
  compare(pair.tail, a, mesh);
  compare(pair.head, b, mesh);
  if (isGeared && pair.movable) m_sharing.join(pair.tail, a, pair.head, b);
  m_train.pairs.push_back(pair);
}

TrainWheel WheelFinder::parallelWheel(const WheelSide& side, const MeshGeometry& geometry,
                                      GearKind kind) const {
  const AxisLine& line = m_placement.lineOfClass(side.axisGroup);
  TrainWheel wheel;
  wheel.link = side.link;
  wheel.axisGroup = side.axisGroup;
  wheel.axis = wide(line.direction);
  wheel.origin =
      wide(line.point) + (wide(geometry.pitchPoint) - wide(line.point)).dot(wheel.axis) * wheel.axis;
  wheel.workingRadius = side.radius;
  wheel.spec = standardGear(kind, side.teeth, 1, 1);
  return wheel;
}

/// A pulley of the running radius. Its teeth are those stated, or so many that its other measures, which are
/// in modules, look like those of a pulley; both pulleys of a pair have one module.
TrainWheel WheelFinder::pulley(const WheelSide& side, const MeshGeometry& geometry, int partnerTeeth) const {
  constexpr int kFewest = 16;
  const int times = (kFewest + std::min(side.teeth, partnerTeeth) - 1) / std::min(side.teeth, partnerTeeth);
  TrainWheel wheel = parallelWheel(side, geometry, wheelOf(geometry.kind, side.teeth, partnerTeeth));
  wheel.spec = standardGear(wheel.spec.kind, side.teeth * times, 2 * side.radius / (side.teeth * times), 1);
  return wheel;
}

/// A wheel on skew axes, with the module of its normal section: that of both.
TrainWheel WheelFinder::crossedWheel(const WheelSide& side, const WheelSide& partner,
                                     const MeshGeometry& geometry) const {
  TrainWheel wheel = parallelWheel(side, geometry, wheelOf(geometry.kind, side.teeth, partner.teeth));
  wheel.spec.module = 2 * std::abs(geometry.tailRadius) / geometry.tailTeeth;
  if (pairKind(geometry.kind).isThreaded) {
    wheel.spec.mateTeeth = partner.teeth;
    wheel.spec.mateRadius = partner.radius;
  }
  return wheel;
}

/// The helices in the wheels' own frames. That of a herringbone wheel is its half on the side against the
/// axis; where the axes of the two point opposite ways, that half meets the other one of the partner.
void WheelFinder::setHelices(const GearMesh& drawn, const MeshGeometry& geometry, TrainWheel& a,
                             TrainWheel& b) const {
  const bool turned = drawn.herringbone && a.axis.dot(b.axis) < 0;
  a.spec.helixAngle = geometry.tailHelix;
  b.spec.helixAngle = turned ? -geometry.headHelix : geometry.headHelix;
  a.spec.herringbone = b.spec.herringbone = drawn.herringbone && geometry.tailHelix != 0;
}

/// Notes where a mesh says other teeth of a wheel than the meshes before it.
void WheelFinder::compare(GearOrdinal wheel, const TrainWheel& with, MeshOrdinal mesh) {
  const TrainWheel& known = m_train.wheels[wheel];
  const MeshOrdinal first = known.meshes.front();
  if (first == mesh) return;
  const bool isSameHelix =
      same(known.spec.helixAngle, with.spec.helixAngle, 1) && known.spec.herringbone == with.spec.herringbone;
  const std::optional<Number>& module = m_mechanism.gearMeshes[mesh].module;
  const std::optional<Number>& was = m_mechanism.gearMeshes[first].module;
  const bool isSameModule = !module || !was || same(module->value(), was->value(), was->value());
  if (!isSameHelix || !isSameModule) m_train.conflicts.push_back({wheel, mesh, first, !isSameHelix});
}

/// The half axes from the apex to the gears. Both point the way of the pitch point; where it does not lie
/// between them, the larger wheel is a ring (an internal cone) and its axis points the other way.
void WheelFinder::bevelWheels(const WheelSide& tail, const WheelSide& head, const MeshGeometry& geometry,
                              TrainWheel& a, TrainWheel& b) const {
  const AxisLine& lineA = m_placement.lineOfClass(tail.axisGroup);
  const AxisLine& lineB = m_placement.lineOfClass(head.axisGroup);
  Vector3d ka = wide(lineA.direction);
  Vector3d kb = wide(lineB.direction);
  const Vector3d across = ka.cross(kb);
  const Vector3d toApex =  // from the point of the tail's line
      wide(geometry.tailToHead).cross(kb).dot(across) / across.squaredNorm() * ka;
  const Vector3d apex = wide(lineA.point) + toApex;
  const Vector3d line = wide(geometry.tailToPitch) - toApex;
  const double reach = line.norm();
  const auto isCrown = [&](const Vector3d& k) { return std::abs(k.dot(line)) < 1e-9 * reach; };
  if (ka.dot(line) < 0) ka = -ka;
  if (kb.dot(line) < 0) kb = -kb;
  if (isCrown(ka) && ka.dot(kb) > 0) ka = -ka;
  if (isCrown(kb) && ka.dot(kb) > 0) kb = -kb;
  const bool between = ka.cross(line).dot(line.cross(kb)) > 0;
  if (!between && !isCrown(ka) && !isCrown(kb)) (tail.radius > head.radius ? ka : kb) *= -1;
  const auto fill = [&](TrainWheel& wheel, const WheelSide& side, int partnerTeeth, const Vector3d& k) {
    wheel.link = side.link;
    wheel.axisGroup = side.axisGroup;
    wheel.axis = k;
    wheel.origin = apex;
    wheel.workingRadius = side.radius;
    const GearKind kind = wheelOf(geometry.kind, side.teeth, partnerTeeth);
    wheel.spec = standardGear(kind, side.teeth, 2 * side.radius / side.teeth, 1);
    wheel.spec.coneAngle = std::atan2(k.cross(line).norm(), k.dot(line));
  };
  fill(a, tail, head.teeth, ka);
  fill(b, head, tail.teeth, kb);
}

/// A face gear, with its pitch plane where the pinion's cylinder touches it; its axis leads away from there.
TrainWheel WheelFinder::faceGear(const WheelSide& side, const MeshGeometry& geometry, int pinionTeeth) const {
  TrainWheel wheel = parallelWheel(side, geometry, wheelOf(geometry.kind, side.teeth, pinionTeeth));
  const bool isTail = side.link == geometry.tail && side.axisGroup == geometry.tailClass;
  const AxisLine& pinion = m_placement.lineOfClass(isTail ? geometry.headClass : geometry.tailClass);
  const Vector3d toPoint =
      isTail ? wide(geometry.tailToPitch) - wide(geometry.tailToHead) : wide(geometry.tailToPitch);
  const Vector3d away = toPoint - toPoint.dot(wide(pinion.direction)) * wide(pinion.direction);
  if (away.dot(wheel.axis) < 0) wheel.axis = -wheel.axis;
  wheel.spec.module = 2 * side.radius / side.teeth;
  wheel.spec.mateTeeth = pinionTeeth;
  wheel.spec.mateRadius = wheel.spec.module * pinionTeeth / 2;
  return wheel;
}

/// Cones that have the pitch plane in common, with the pitch point at their large ends.
void WheelFinder::offsetWheels(const WheelSide& tail, const WheelSide& head, const MeshGeometry& geometry,
                               TrainWheel& a, TrainWheel& b) const {
  const AxisLine& line = m_placement.lineOfClass(tail.axisGroup);
  const OffsetCones cones =
      offsetCones(geometry, line.direction, m_placement.lineOfClass(head.axisGroup).direction);
  const auto fill = [&](TrainWheel& wheel, const WheelSide& side, int partnerTeeth, const OffsetCone& cone) {
    wheel.link = side.link;
    wheel.axisGroup = side.axisGroup;
    wheel.axis = wide(cone.axis);
    wheel.origin = wide(line.point) + wide(cone.apex);
    wheel.workingRadius = side.radius;
    const GearKind kind = wheelOf(geometry.kind, side.teeth, partnerTeeth);
    wheel.spec = standardGear(kind, side.teeth, 2 * side.radius / side.teeth, 1);
    wheel.spec.coneAngle = cone.angle;
  };
  fill(a, tail, head.teeth, cones.tail);
  fill(b, head, tail.teeth, cones.head);
}

bool WheelFinder::isSame(const TrainWheel& a, const TrainWheel& b) {
  if (a.id || b.id) return a.id == b.id;
  if (a.axisGroup != b.axisGroup || a.spec.teeth != b.spec.teeth || a.spec.kind != b.spec.kind) return false;
  const double scale = a.workingRadius;
  if (isFaceGear(a.spec) && (a.axis.dot(b.axis) < 0 || a.spec.mateTeeth != b.spec.mateTeeth)) return false;
  if ((a.origin - b.origin).norm() > 1e-6 * scale) return false;
  if (!isConical(a.spec)) {
    return std::abs(a.workingRadius - b.workingRadius) <= kSameWheel * scale;
  }
  return a.axis.dot(b.axis) > 0 && same(a.workingRadius, b.workingRadius, scale) &&
         same(a.spec.coneAngle, b.spec.coneAngle, 1);
}

/// The link's wheels that the wheel may be.
std::vector<GearOrdinal> WheelFinder::like(const TrainWheel& wheel) const {
  std::vector<GearOrdinal> found;
  for (const GearOrdinal w : m_ofLink[wheel.link]) {
    if (isSame(m_train.wheels[static_cast<std::size_t>(w)], wheel)) found.push_back(w);
  }
  return found;
}

int WheelFinder::add(TrainWheel wheel, std::optional<int> known, MeshOrdinal mesh) {
  if (known) {
    TrainWheel& shared = m_train.wheels[static_cast<std::size_t>(*known)];
    const double plane = (wheel.origin - shared.origin).dot(shared.axis);
    shared.meshes.push_back(mesh);
    shared.planes.push_back(same(plane, 0, shared.workingRadius) ? 0 : plane);
    return *known;
  }
  const int position = static_cast<int>(m_train.wheels.size());
  m_ofLink[wheel.link].push_back(position);
  wheel.meshes.push_back(mesh);
  wheel.planes.push_back(0);
  m_train.wheels.push_back(std::move(wheel));
  return position;
}

}  // namespace

TrainWheels wheelsOf(const Mechanism& mechanism, const Placement& placement, const std::stop_token& stop) {
  if (!placement.classes) return {};
  return WheelFinder(mechanism, placement).find(stop);
}

}  // namespace geargraph
