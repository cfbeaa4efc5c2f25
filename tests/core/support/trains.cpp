#include "tests/core/support/trains.h"

#include "core/base/contract.h"
#include "tests/core/support/mechanisms.h"
#include <algorithm>
#include <array>
#include <random>

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
LinkId link(int number) {
  return LinkId(std::to_string(number));
}

NumberTriple triple(const std::vector<std::string>& texts) {
  return {*Number::fromText(texts.at(0)), *Number::fromText(texts.at(1)), *Number::fromText(texts.at(2))};
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
TrainBuilder::TrainBuilder(int links) {
  for (int i = 0; i <= links; ++i) m_mechanism.links.push_back({link(i), i == 0 ? "ground" : "", {}});
}

TrainBuilder& TrainBuilder::axis(const std::string& id, const std::vector<std::string>& point,
                                 const std::vector<std::string>& direction) {
  m_mechanism.axes.push_back({AxisId(id), triple(point), triple(direction), {}});
  return *this;
}

TrainBuilder& TrainBuilder::joint(int tail, int head, const std::string& axis, const std::string& offset) {
  const AxisId id(axis);
  if (m_mechanism.find(id) == nullptr) m_mechanism.axes.push_back({id, {}, {}, {}});
  const int label = m_mechanism.n() + m_mechanism.t() + 1;
  m_mechanism.turningJoints.push_back(
      {JointId(std::to_string(label)), link(tail), link(head), id, *Number::fromText(offset), {}});
  return *this;
}

TrainBuilder& TrainBuilder::mesh(int tail, int head, int tailTeeth, int headTeeth,
                                 std::optional<MeshKind> kind, const std::vector<std::string>& pitchPoint) {
  GearMesh pair;
  pair.id = MeshId(std::to_string(m_mechanism.n() + m_mechanism.t() + m_mechanism.c() + 1));
  pair.tail = link(tail);
  pair.head = link(head);
  pair.tailTeeth = tailTeeth;
  pair.headTeeth = headTeeth;
  pair.kind = kind;
  if (!pitchPoint.empty()) pair.pitchPoint = triple(pitchPoint);
  m_mechanism.gearMeshes.push_back(pair);
  return *this;
}

TrainBuilder& TrainBuilder::inputs(const std::vector<std::pair<int, std::string>>& speedsByLabel) {
  m_mechanism.inputs.emplace();
  for (const auto& [label, speed] : speedsByLabel) {
    m_mechanism.inputs->push_back({JointId(std::to_string(label)), *Number::fromText(speed), {}});
  }
  return *this;
}

Mechanism robot() {
  return TrainBuilder(7)
      .axis("a", {"0", "-54", "0"})
      .axis("b", {"0", "0", "0"})
      .axis("c", {"0", "0", "60"}, {"0", "1", "0"})
      .axis("d", {"0", "0", "96"})
      .axis("e", {"0", "0", "132"}, {"0", "1", "0"})
      .joint(0, 4, "a")
      .joint(0, 5, "b")
      .joint(0, 1, "b", "30")
      .joint(1, 6, "c", "40")
      .joint(1, 2, "c", "-40")
      .joint(2, 7, "d")
      .joint(2, 3, "e", "-40")
      .mesh(4, 1, 18, 36, MeshKind::external, {"0", "-36", "0"})
      .mesh(5, 2, 20, 30, MeshKind::bevel, {"0", "-20", "30"})
      .mesh(6, 7, 24, 18, MeshKind::bevel, {"0", "18", "84"})
      .mesh(7, 3, 16, 24, MeshKind::bevel, {"0", "16", "108"})
      .inputs({{8, "1"}, {9, "1/2"}, {11, "0"}})
      .build();
}

Mechanism planetary(int sunTeeth, int planetTeeth, int planets) {
  TrainBuilder train(3 + planets);
  train.joint(0, 1, "a").joint(0, 2, "a").joint(0, 3, "a");
  for (int i = 0; i < planets; ++i) train.joint(3, 4 + i, "b" + std::to_string(i));
  for (int i = 0; i < planets; ++i) {
    train.mesh(1, 4 + i, sunTeeth, planetTeeth, MeshKind::external);
    train.mesh(4 + i, 2, planetTeeth, sunTeeth + 2 * planetTeeth, MeshKind::internal);
  }
  return train.build();
}

namespace {

/// An axis of the random train: its links, where it lies, and the axis beside it that it meshes with.
struct RandomAxis {
  std::vector<int> links;  ///< the top first
  int neighbour = -1;      ///< an axis that shares the top
  std::array<int, 3> point{};
  int along = 2;  ///< parallel to x, y or z
  bool parallel = true;
};

class RandomTrain {
 public:
  RandomTrain(std::uint64_t seed, int n) : m_random(seed), m_train(n) {
    for (int v = 1; v <= n; ++v) addLink(v);
  }

  Mechanism build(int meshes) {
    std::vector<int> candidates;
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
      if (m_axes[i].neighbour >= 0 && m_axes[i].links.size() > 1) candidates.push_back(static_cast<int>(i));
    }
    for (int i = 0; i < meshes && !candidates.empty(); ++i)
      addMesh(candidates[below(static_cast<int>(candidates.size()))]);
    return m_train.build();
  }

 private:
  int below(int limit) { return static_cast<int>(m_random() % static_cast<std::uint64_t>(limit)); }

  void addLink(int v) {
    int on = -1;
    int parent = 0;
    if (!m_axes.empty() && below(10) < 5) {
      on = below(static_cast<int>(m_axes.size()));
      parent = m_axes[on].links[below(static_cast<int>(m_axes[on].links.size()))];
    } else {
      parent = below(v);
      on = addAxis(parent);
    }
    m_axes[on].links.push_back(v);
    const std::string name = "x" + std::to_string(on);
    if (below(2) == 0) {
      m_train.joint(parent, v, name);
    } else {
      m_train.joint(v, parent, name);
    }
  }

  int addAxis(int top) {
    RandomAxis axis;
    axis.links = {top};
    std::vector<int> around;
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
      if (std::find(m_axes[i].links.begin(), m_axes[i].links.end(), top) != m_axes[i].links.end()) {
        around.push_back(static_cast<int>(i));
      }
    }
    if (!around.empty()) {
      axis.neighbour = around[below(static_cast<int>(around.size()))];
      const RandomAxis& beside = m_axes[axis.neighbour];
      axis.point = beside.point;
      axis.parallel = below(3) > 0;
      if (axis.parallel) {
        axis.along = beside.along;
        axis.point[(axis.along + 1) % 3] += offset();
        axis.point[(axis.along + 2) % 3] += offset();
      } else {
        axis.along = (beside.along + 1 + below(2)) % 3;
        axis.point[beside.along] += offset();
      }
    } else {
      for (int& coordinate : axis.point) coordinate = offset();
    }
    const auto at = [&](int i) { return std::to_string(axis.point[i]); };
    std::vector<std::string> direction{"0", "0", "0"};
    direction[axis.along] = below(2) == 0 ? "1" : "-3";
    m_train.axis("x" + std::to_string(m_axes.size()), {at(0), at(1), at(2)}, direction);
    m_axes.push_back(axis);
    return static_cast<int>(m_axes.size()) - 1;
  }

  /// A number of its own for every call, so that no two axes ever coincide.
  int offset() { return (below(2) == 0 ? 1 : -1) * (1000 * ++m_offsets + below(1000)); }

  void addMesh(int outer) {
    const RandomAxis& axis = m_axes[outer];
    const int top = axis.links.front();
    const RandomAxis& beside = m_axes[axis.neighbour];
    std::vector<int> inner = beside.links;
    std::erase(inner, top);
    if (inner.empty()) return;
    int tail = inner[below(static_cast<int>(inner.size()))];
    int head = axis.links[1 + below(static_cast<int>(axis.links.size()) - 1)];
    if (below(2) == 0) std::swap(tail, head);
    const int tailTeeth = 12 + below(60);
    int headTeeth = 12 + below(60);
    MeshKind kind = MeshKind::bevel;
    if (axis.parallel) kind = below(3) == 0 ? MeshKind::internal : MeshKind::external;
    if (kind == MeshKind::internal && tailTeeth == headTeeth) ++headTeeth;
    m_train.mesh(tail, head, tailTeeth, headTeeth, kind);
  }

  std::mt19937_64 m_random;
  TrainBuilder m_train;
  std::vector<RandomAxis> m_axes;
  int m_offsets = 0;
};

}  // namespace

Mechanism randomTrain(std::uint64_t seed, int n, int meshes) {
  return RandomTrain(seed, n).build(meshes);
}

Mechanism moved(Mechanism mechanism) {
  // Rows of a rotation: (1, 2, 2)/3, (2, 1, -2)/3, (2, -2, 1)/3 with one sign turned for determinant +1.
  const auto turned = [](const NumberTriple& v, int shift) {
    const auto row = [&](int a, int b, int c, int d) {
      return Number((Rational(a) * v[0].exact() + Rational(b) * v[1].exact() + Rational(c) * v[2].exact()) /
                        Rational(3) +
                    Rational(d * shift));
    };
    return NumberTriple{row(1, 2, 2, 5), row(2, 1, -2, -7), row(-2, 2, -1, 11)};
  };
  for (Axis& axis : mechanism.axes) {
    if (axis.point) axis.point = turned(*axis.point, 1);
    if (axis.direction) axis.direction = turned(*axis.direction, 0);
  }
  for (GearMesh& mesh : mechanism.gearMeshes) {
    if (mesh.pitchPoint) mesh.pitchPoint = turned(*mesh.pitchPoint, 1);
  }
  return mechanism;
}

}  // namespace geargraph::test
