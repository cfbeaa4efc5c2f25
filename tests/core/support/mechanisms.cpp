#include "tests/core/support/mechanisms.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace geargraph::test {
namespace {

LinkId link(int number) {
  return LinkId(std::to_string(number));
}

}  // namespace

Mechanism robotTopology() {
  Mechanism robot;
  robot.name = "Geared robotic mechanism";
  for (int i = 0; i <= 7; ++i) robot.links.push_back({link(i), i == 0 ? "ground" : "", {}});
  for (const char* axis : {"a", "b", "c", "d", "e"}) robot.axes.push_back({AxisId(axis), {}, {}, {}});
  const auto joint = [&](int label, int tail, int head, const char* axis) {
    robot.turningJoints.push_back(
        {JointId(std::to_string(label)), link(tail), link(head), AxisId(axis), Number(0), {}});
  };
  joint(8, 0, 4, "a");
  joint(9, 0, 5, "b");
  joint(10, 0, 1, "b");
  joint(11, 1, 6, "c");
  joint(12, 1, 2, "c");
  joint(13, 2, 7, "d");
  joint(14, 2, 3, "e");
  const auto mesh = [&](int label, int tail, int head, int tailTeeth, int headTeeth) {
    GearMesh pair;
    pair.id = MeshId(std::to_string(label));
    pair.tail = link(tail);
    pair.head = link(head);
    pair.tailTeeth = tailTeeth;
    pair.headTeeth = headTeeth;
    robot.gearMeshes.push_back(pair);
  };
  mesh(15, 4, 1, 18, 36);
  mesh(16, 5, 2, 20, 30);
  mesh(17, 6, 7, 24, 18);
  mesh(18, 7, 3, 16, 24);
  return robot;
}

Mechanism randomTree(std::uint64_t seed, int n, int c) {
  std::mt19937_64 random(seed);
  const auto below = [&](int limit) {
    return static_cast<int>(random() % static_cast<std::uint64_t>(limit));
  };
  Mechanism mechanism;
  for (int i = 0; i <= n; ++i) mechanism.links.push_back({link(i), {}, {}});
  mechanism.axes.push_back({AxisId("a"), {}, {}, {}});
  std::vector<int> shuffled(static_cast<std::size_t>(n));
  std::iota(shuffled.begin(), shuffled.end(), 1);
  for (std::size_t i = shuffled.size(); i > 1; --i) std::swap(shuffled[i - 1], shuffled[random() % i]);

  std::vector<int> placed{0};
  for (const int next : shuffled) {
    // Mostly near the newest link, so that trees are deep as well as bushy.
    const int span = std::min<int>(static_cast<int>(placed.size()), 1 + below(4) * below(6));
    const int parent = placed[placed.size() - 1 - static_cast<std::size_t>(below(std::max(1, span)))];
    const bool outward = below(3) != 0;
    TurningJoint joint;
    joint.tail = link(outward ? parent : next);
    joint.head = link(outward ? next : parent);
    joint.axis = AxisId("a");
    mechanism.turningJoints.push_back(joint);
    placed.push_back(next);
  }
  for (std::size_t i = mechanism.turningJoints.size(); i > 1; --i) {
    std::swap(mechanism.turningJoints[i - 1], mechanism.turningJoints[random() % i]);
  }
  for (int j = 0; j < n; ++j) {
    mechanism.turningJoints[static_cast<std::size_t>(j)].id = JointId("j" + std::to_string(j));
  }
  for (int m = 0; m < c && n >= 1; ++m) {
    GearMesh mesh;
    mesh.id = MeshId("m" + std::to_string(m));
    const int tail = below(n + 1);
    mesh.tail = link(tail);
    mesh.head = link((tail + 1 + below(n)) % (n + 1));
    mechanism.gearMeshes.push_back(mesh);
  }
  return mechanism;
}

Dense dense(const IntegerMatrix& matrix) {
  Dense values(static_cast<std::size_t>(matrix.rows()));
  for (int i = 0; i < matrix.rows(); ++i) {
    for (int j = 0; j < matrix.columns(); ++j)
      values[static_cast<std::size_t>(i)].push_back(matrix.entry(i, j));
  }
  return values;
}

Dense denseFromRows(const IntegerMatrix& matrix) {
  Dense values(static_cast<std::size_t>(matrix.rows()));
  std::vector<MatrixEntry> entries;
  for (int i = 0; i < matrix.rows(); ++i) {
    auto& row = values[static_cast<std::size_t>(i)];
    row.assign(static_cast<std::size_t>(matrix.columns()), 0);
    matrix.rowEntries(i, entries);
    for (const MatrixEntry& entry : entries) row[static_cast<std::size_t>(entry.column)] = entry.value;
  }
  return values;
}

Dense product(const Dense& a, const Dense& b) {
  const std::size_t columns = b.empty() ? 0 : b.front().size();
  Dense result(a.size(), std::vector<int>(columns, 0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      for (std::size_t j = 0; j < columns; ++j) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

Dense transposed(const Dense& a) {
  Dense result(a.empty() ? 0 : a.front().size(), std::vector<int>(a.size()));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < a[i].size(); ++j) result[j][i] = a[i][j];
  }
  return result;
}

Dense columnsOf(const Dense& a, int first, int last) {
  Dense result;
  for (const auto& row : a) result.emplace_back(row.begin() + first, row.begin() + last);
  return result;
}

}  // namespace geargraph::test
