#include "tests/core/support/train_sketch.h"

#include <algorithm>
#include <array>
#include <random>

namespace geargraph::test {
namespace {

LinkId link(int number) {
  return LinkId(std::to_string(number));
}

NumberTriple triple(const std::vector<std::string>& texts) {
  return {*Number::fromText(texts.at(0)), *Number::fromText(texts.at(1)), *Number::fromText(texts.at(2))};
}

}  // namespace

TrainSketch::TrainSketch(int links) {
  for (int i = 0; i <= links; ++i) m_mechanism.links.push_back({link(i), i == 0 ? "ground" : "", {}});
}

TrainSketch& TrainSketch::axis(const std::string& id, const std::vector<std::string>& point,
                               const std::vector<std::string>& direction) {
  m_mechanism.axes.push_back({AxisId(id), triple(point), triple(direction), {}});
  return *this;
}

TrainSketch& TrainSketch::joint(int tail, int head, const std::string& axis, const std::string& offset) {
  const AxisId id(axis);
  if (m_mechanism.find(id) == nullptr) m_mechanism.axes.push_back({id, {}, {}, {}});
  const int label = m_mechanism.n() + m_mechanism.t() + 1;
  m_mechanism.turningJoints.push_back(
      {JointId(std::to_string(label)), link(tail), link(head), id, *Number::fromText(offset), {}});
  return *this;
}

TrainSketch& TrainSketch::mesh(int tail, int head, int tailTeeth, int headTeeth, std::optional<MeshKind> kind,
                               const std::vector<std::string>& pitchPoint) {
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

TrainSketch& TrainSketch::inputs(const std::vector<std::pair<int, std::string>>& speedsByLabel) {
  m_mechanism.inputs.emplace();
  for (const auto& [label, speed] : speedsByLabel) {
    m_mechanism.inputs->push_back({JointId(std::to_string(label)), *Number::fromText(speed), {}});
  }
  return *this;
}

Mechanism planetary(int sunTeeth, int planetTeeth, int planets) {
  TrainSketch train(3 + planets);
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
  TrainSketch m_train;
  std::vector<RandomAxis> m_axes;
  int m_offsets = 0;
};

}  // namespace

Mechanism randomTrain(std::uint64_t seed, int n, int meshes) {
  return RandomTrain(seed, n).build(meshes);
}

}  // namespace geargraph::test
