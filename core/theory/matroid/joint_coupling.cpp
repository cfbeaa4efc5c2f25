#include "core/theory/matroid/joint_coupling.h"

#include <algorithm>

#include "core/foundations/base/contract.h"

namespace geargraph::inline matroid {
namespace {

using GainRow = std::vector<Rational>;

/// Rows in echelon form, each with a leading 1; a row that depends on those before is not taken.
class IndependentRows {
 public:
  bool take(GainRow row) {
    for (const auto& [column, known] : m_rows) {
      const Rational factor = row[column];
      if (factor.isZero()) continue;
      for (std::size_t i = 0; i < row.size(); ++i) row[i] -= factor * known[i];
    }
    const auto lead =
        std::find_if(row.begin(), row.end(), [](const Rational& each) { return !each.isZero(); });
    if (lead == row.end()) return false;
    const Rational scale = lead->inverse();
    const auto column = static_cast<std::size_t>(lead - row.begin());
    for (Rational& each : row) each *= scale;
    m_rows.emplace_back(column, std::move(row));
    return true;
  }

 private:
  std::vector<std::pair<std::size_t, GainRow>> m_rows;
};

bool areIndependent(const ExactSolution& solution, const std::vector<JointOrdinal>& joints) {
  IndependentRows rows;
  return std::all_of(joints.begin(), joints.end(),
                     [&](JointOrdinal joint) { return rows.take(gainsOf(solution, joint)); });
}

/// [A | 1] brought to [1 | A^-1]; false if A is singular.
bool reduceToUnit(std::vector<GainRow>& rows) {
  const std::size_t size = rows.size();
  for (std::size_t column = 0; column < size; ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(column), rows.end(),
                                    [&](const GainRow& row) { return !row[column].isZero(); });
    if (pivot == rows.end()) return false;
    std::swap(*pivot, rows[column]);
    const Rational scale = rows[column][column].inverse();
    for (Rational& each : rows[column]) each *= scale;
    for (std::size_t other = 0; other < size; ++other) {
      if (other == column || rows[other][column].isZero()) continue;
      const Rational factor = rows[other][column];
      for (std::size_t i = column; i < 2 * size; ++i) rows[other][i] -= factor * rows[column][i];
    }
  }
  return true;
}

std::vector<JointOrdinal> jointsTo(const SpanningTree& tree, LinkOrdinal link) {
  std::vector<JointOrdinal> joints;
  for (const PathStep& step : treePath(tree, 0, link)) joints.push_back(step.joint);
  return joints;
}

int meshesOf(const Mechanism& mechanism, LinkOrdinal link) {
  const LinkId& id = mechanism.links[static_cast<std::size_t>(static_cast<int>(link))].id;
  return static_cast<int>(
      std::count_if(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(),
                    [&](const GearMesh& mesh) { return mesh.tail == id || mesh.head == id; }));
}

}  // namespace

std::vector<Rational> gainsOf(const ExactSolution& solution, JointOrdinal joint) {
  const std::size_t size = solution.inputs.size();
  GainRow row(size);
  const int place = joint;
  if (const auto input = std::find(solution.inputs.begin(), solution.inputs.end(), place);
      input != solution.inputs.end()) {
    row[static_cast<std::size_t>(input - solution.inputs.begin())] = Rational(1);
    return row;
  }
  const auto output = std::find(solution.outputs.begin(), solution.outputs.end(), place);
  GEARGRAPH_REQUIRE(output != solution.outputs.end());
  GEARGRAPH_REQUIRE(solution.matrix.size() == size * solution.outputs.size());
  const auto begin =
      solution.matrix.begin() + (output - solution.outputs.begin()) * static_cast<std::ptrdiff_t>(size);
  std::copy(begin, begin + static_cast<std::ptrdiff_t>(size), row.begin());
  return row;
}

std::optional<JointCoupling> jointCoupling(const ExactSolution& solution, std::vector<JointOrdinal> joints) {
  const std::size_t size = solution.inputs.size();
  GEARGRAPH_REQUIRE(joints.size() == size);
  JointCoupling coupling;
  for (const int input : solution.inputs) coupling.motors.emplace_back(input);
  std::vector<GainRow> rows;
  for (std::size_t at = 0; at < size; ++at) {
    GainRow row = gainsOf(solution, joints[at]);
    coupling.motorToJoint.insert(coupling.motorToJoint.end(), row.begin(), row.end());
    row.resize(2 * size);
    row[size + at] = Rational(1);
    rows.push_back(std::move(row));
  }
  if (!reduceToUnit(rows)) return std::nullopt;
  for (const GainRow& row : rows) {
    coupling.jointToMotor.insert(coupling.jointToMotor.end(), row.begin() + static_cast<std::ptrdiff_t>(size),
                                 row.end());
  }
  coupling.joints = std::move(joints);
  return coupling;
}

std::optional<std::vector<JointOrdinal>> usualJoints(const ExactSolution& solution, const SpanningTree& tree,
                                                     const Mechanism& mechanism) {
  const std::size_t size = solution.inputs.size();
  if (size == 0) return std::nullopt;
  std::optional<std::vector<JointOrdinal>> chain;
  int fewest = 0;
  for (LinkOrdinal link = 1; link <= mechanism.n(); ++link) {
    if (static_cast<std::size_t>(tree.depth(link)) != size) continue;
    const int meshes = meshesOf(mechanism, link);
    if (chain && meshes >= fewest) continue;
    std::vector<JointOrdinal> joints = jointsTo(tree, link);
    const bool isDriven = std::all_of(joints.begin(), joints.end(), [&](JointOrdinal joint) {
      return std::find(solution.outputs.begin(), solution.outputs.end(), static_cast<int>(joint)) !=
             solution.outputs.end();
    });
    if (!isDriven || !areIndependent(solution, joints)) continue;
    chain = std::move(joints);
    fewest = meshes;
  }
  if (chain) return chain;

  std::vector<JointOrdinal> joints;
  IndependentRows rows;
  for (const std::vector<int>* group : {&solution.outputs, &solution.inputs}) {
    for (const int joint : *group) {
      if (joints.size() < size && rows.take(gainsOf(solution, joint))) joints.emplace_back(joint);
    }
  }
  return joints;
}

}  // namespace geargraph::inline matroid
