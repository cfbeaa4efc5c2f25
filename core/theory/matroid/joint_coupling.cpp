#include "core/theory/matroid/joint_coupling.h"

#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/foundations/exact/elimination.h"
#include "core/foundations/exact/fields.h"

namespace geargraph {
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

/// The inverse of a square matrix, row by row; std::nullopt if it is singular.
std::optional<std::vector<Rational>> inverseOf(const std::vector<Rational>& matrix, int size) {
  const RationalField field;
  SparseRows<Rational> rows;  // over the motors, then over the joints, which are given
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const Rational& entry = matrix[static_cast<std::size_t>(row * size + column)];
      if (!entry.isZero()) rows.add(column, entry);
    }
    rows.add(size + row, Rational(-1));
    rows.endRow();
  }
  const auto system = eliminate(field, std::move(rows), size, 2 * size);
  if (!system->freeColumns.empty()) return std::nullopt;
  std::vector<Rational> inverse(matrix.size());
  std::vector<Rational> x(static_cast<std::size_t>(2 * size));
  for (int joint = 0; joint < size; ++joint) {
    x[static_cast<std::size_t>(size + joint)] = 1;
    substitute(field, *system, std::span<Rational>(x));
    x[static_cast<std::size_t>(size + joint)] = 0;
    for (int motor = 0; motor < size; ++motor)
      inverse[static_cast<std::size_t>(motor * size + joint)] = x[static_cast<std::size_t>(motor)];
  }
  return inverse;
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
  for (const JointOrdinal joint : joints) {
    const GainRow row = gainsOf(solution, joint);
    coupling.motorToJoint.insert(coupling.motorToJoint.end(), row.begin(), row.end());
  }
  auto inverse = inverseOf(coupling.motorToJoint, static_cast<int>(size));
  if (!inverse) return std::nullopt;
  coupling.jointToMotor = *std::move(inverse);
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

}  // namespace geargraph
