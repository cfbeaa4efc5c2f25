#include "tests/core/support/trains.h"

#include "core/foundations/base/contract.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph::test {
namespace {

ExactTriple cross(const ExactTriple& a, const ExactTriple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

ExactTriple difference(const ExactTriple& a, const ExactTriple& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Where two lines meet.
ExactTriple apexOf(const ExactTriple& pointA, const ExactTriple& directionA, const ExactTriple& pointB,
                   const ExactTriple& directionB) {
  const ExactTriple normal = cross(directionA, directionB);
  const Rational along = dot(cross(difference(pointB, pointA), directionB), normal) / dot(normal, normal);
  return sum(pointA, scaled(directionA, along));
}

}  // namespace

ExactTriple sum(const ExactTriple& a, const ExactTriple& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

ExactTriple scaled(const ExactTriple& a, const Rational& factor) {
  return {a[0] * factor, a[1] * factor, a[2] * factor};
}

Rational dot(const ExactTriple& a, const ExactTriple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

NumberTriple numbers(const ExactTriple& triple) {
  return {Number(triple[0]), Number(triple[1]), Number(triple[2])};
}

ExactTriple exactOf(const NumberTriple& triple) {
  return {triple[0].exact(), triple[1].exact(), triple[2].exact()};
}

ExactTriple unitDirection(const Axis& axis) {
  const ExactTriple direction = exactOf(*axis.direction);
  const std::optional<Rational> length = dot(direction, direction).squareRoot();
  GEARGRAPH_REQUIRE(length.has_value());
  return scaled(direction, length->inverse());
}

TrainBuilder::TrainBuilder(std::string name) : m_mechanism(emptyMechanism()) {
  m_mechanism.name = std::move(name);
}

int TrainBuilder::axis(const ExactTriple& point, const ExactTriple& direction) {
  const int number = static_cast<int>(m_mechanism.axes.size());
  const std::string id =
      number < 26 ? std::string(1, static_cast<char>('a' + number)) : "x" + std::to_string(number);
  m_mechanism.axes.push_back({AxisId(id), numbers(point), numbers(direction), {}});
  return number;
}

int TrainBuilder::addLink(int parent, int axis, bool reversed, std::string name) {
  const int number = static_cast<int>(m_mechanism.links.size());
  m_mechanism.links.push_back({LinkId(std::to_string(number)), std::move(name), {}});
  TurningJoint joint;
  joint.id = JointId("j" + std::to_string(number - 1));
  joint.tail = LinkId(std::to_string(reversed ? number : parent));
  joint.head = LinkId(std::to_string(reversed ? parent : number));
  joint.axis = m_mechanism.axes[static_cast<std::size_t>(axis)].id;
  m_mechanism.turningJoints.push_back(joint);
  return number;
}

int TrainBuilder::link(int parent, int axis, std::string name) {
  return addLink(parent, axis, false, std::move(name));
}

int TrainBuilder::linkReversed(int parent, int axis, std::string name) {
  return addLink(parent, axis, true, std::move(name));
}

GearMesh& TrainBuilder::mesh(int tail, int head, int tailTeeth, int headTeeth,
                             const ExactTriple& pitchPoint) {
  GearMesh pair;
  pair.id = MeshId("m" + std::to_string(m_mechanism.gearMeshes.size()));
  pair.tail = LinkId(std::to_string(tail));
  pair.head = LinkId(std::to_string(head));
  pair.tailTeeth = tailTeeth;
  pair.headTeeth = headTeeth;
  pair.pitchPoint = numbers(pitchPoint);
  return m_mechanism.gearMeshes.emplace_back(pair);
}

void TrainBuilder::parallel(int tail, int tailAxis, int tailTeeth, int head, int headAxis, int headTeeth,
                            bool external) {
  const ExactTriple u = unitDirection(m_mechanism.axes[static_cast<std::size_t>(tailAxis)]);
  const ExactTriple a = exactOf(*m_mechanism.axes[static_cast<std::size_t>(tailAxis)].point);
  const ExactTriple b = exactOf(*m_mechanism.axes[static_cast<std::size_t>(headAxis)].point);
  const ExactTriple apart = difference(b, a);
  const ExactTriple across = difference(apart, scaled(u, dot(apart, u)));
  // From the tail's axis, N_i / (N_i + N_j) of the way to the head's (external), beyond one of them
  // (internal).
  const Rational share =
      external ? Rational(tailTeeth, tailTeeth + headTeeth) : Rational(tailTeeth, tailTeeth - headTeeth);
  mesh(tail, head, tailTeeth, headTeeth, sum(a, scaled(across, share))).kind =
      external ? MeshKind::external : MeshKind::internal;
}

void TrainBuilder::external(int tail, int tailAxis, int tailTeeth, int head, int headAxis, int headTeeth) {
  parallel(tail, tailAxis, tailTeeth, head, headAxis, headTeeth, true);
}

void TrainBuilder::internal(int tail, int tailAxis, int tailTeeth, int head, int headAxis, int headTeeth) {
  parallel(tail, tailAxis, tailTeeth, head, headAxis, headTeeth, false);
}

void TrainBuilder::bevel(int tail, int tailAxis, int tailTeeth, int head, int headAxis, int headTeeth,
                         int sign, const Rational& side) {
  const Axis& first = m_mechanism.axes[static_cast<std::size_t>(tailAxis)];
  const Axis& second = m_mechanism.axes[static_cast<std::size_t>(headAxis)];
  const ExactTriple apex = apexOf(exactOf(*first.point), exactOf(*first.direction), exactOf(*second.point),
                                  exactOf(*second.direction));
  const ExactTriple pitchLine = sum(scaled(unitDirection(first), headTeeth),
                                    scaled(unitDirection(second), Rational(-sign * tailTeeth)));
  mesh(tail, head, tailTeeth, headTeeth, sum(apex, scaled(pitchLine, side))).kind = MeshKind::bevel;
}

void TrainBuilder::input(int joint, const Rational& speed) {
  if (!m_mechanism.inputs) m_mechanism.inputs.emplace();
  m_mechanism.inputs->push_back(
      {m_mechanism.turningJoints[static_cast<std::size_t>(joint)].id, Number(speed), {}});
}

ExactRotation rotation(int w, int x, int y, int z) {
  const Rational size = w * w + x * x + y * y + z * z;
  const auto entry = [&](int value) { return Rational(value) / size; };
  return {{{entry(w * w + x * x - y * y - z * z), entry(2 * (x * y - w * z)), entry(2 * (x * z + w * y))},
           {entry(2 * (x * y + w * z)), entry(w * w - x * x + y * y - z * z), entry(2 * (y * z - w * x))},
           {entry(2 * (x * z - w * y)), entry(2 * (y * z + w * x)), entry(w * w - x * x - y * y + z * z)}}};
}

Mechanism moved(Mechanism mechanism, const ExactRotation& rotation, const ExactTriple& shift) {
  const auto turned = [&](const NumberTriple& triple) {
    const ExactTriple v = exactOf(triple);
    return ExactTriple{dot(rotation[0], v), dot(rotation[1], v), dot(rotation[2], v)};
  };
  for (Axis& axis : mechanism.axes) {
    if (axis.point) axis.point = numbers(sum(turned(*axis.point), shift));
    if (axis.direction) axis.direction = numbers(turned(*axis.direction));
  }
  for (GearMesh& mesh : mechanism.gearMeshes) {
    if (mesh.pitchPoint) mesh.pitchPoint = numbers(sum(turned(*mesh.pitchPoint), shift));
  }
  return mechanism;
}

Mechanism withAxisFlipped(Mechanism mechanism, int axis) {
  Axis& flipped = mechanism.axes[static_cast<std::size_t>(axis)];
  flipped.direction = numbers(scaled(exactOf(*flipped.direction), -1));
  for (TurningJoint& joint : mechanism.turningJoints) {
    if (joint.axis == flipped.id) std::swap(joint.tail, joint.head);
  }
  return mechanism;
}

Mechanism withDirectionsScaled(Mechanism mechanism, const std::vector<Rational>& factors) {
  for (std::size_t i = 0; i < mechanism.axes.size(); ++i) {
    Axis& axis = mechanism.axes[i];
    axis.direction = numbers(scaled(exactOf(*axis.direction), factors[i % factors.size()]));
  }
  return mechanism;
}

Mechanism robot() {
  Mechanism robot = robotTopology();
  const auto place = [&](std::size_t axis, const ExactTriple& point, const ExactTriple& direction) {
    robot.axes[axis].point = numbers(point);
    robot.axes[axis].direction = numbers(direction);
  };
  place(0, {0, -54, 0}, {0, 0, 1});
  place(1, {0, 0, 0}, {0, 0, 1});
  place(2, {0, 0, 60}, {0, 1, 0});
  place(3, {0, 0, 90}, {0, 0, 1});
  place(4, {0, 0, 140}, {0, 1, 0});
  const auto touch = [&](std::size_t mesh, const ExactTriple& point, MeshKind kind) {
    robot.gearMeshes[mesh].pitchPoint = numbers(point);
    robot.gearMeshes[mesh].kind = kind;
  };
  touch(0, {0, -36, 0}, MeshKind::external);
  touch(1, {0, -20, 30}, MeshKind::bevel);
  touch(2, {0, 18, 84}, MeshKind::bevel);
  touch(3, {0, 16, 116}, MeshKind::bevel);
  robot.inputs = {
      {JointId("8"), Number(1), {}}, {JointId("9"), Number(1), {}}, {JointId("11"), Number(1), {}}};
  return robot;
}

}  // namespace geargraph::test
