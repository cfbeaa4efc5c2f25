#include "core/teaching/force_tables/dual_equations.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/teaching/force_tables/cutset_words.h"

namespace geargraph {
namespace {

/// A term of a sum: " + 60", " - 60"; the first without a plus.
void addFactor(std::string& sum, bool isNegative, const std::string& text) {
  sum += sum.empty() ? (isNegative ? "-" : "") : (isNegative ? " - " : " + ");
  sum += text;
}

class DualityEntries {
 public:
  DualityEntries(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement)
      : m_mechanism(mechanism), m_matrix(mechanism, model, placement) {}

  /// 0 where the row has no entry at the joint.
  [[nodiscard]] int entry(MeshOrdinal mesh, JointOrdinal joint) const {
    for (const CoefficientMatrix::Entry& each : m_matrix.row(mesh))
      if (each.joint == joint) return inTeeth(mesh, each);
    return 0;
  }
  [[nodiscard]] std::optional<int> firstMesh(JointOrdinal joint) const {
    for (MeshOrdinal mesh = 0; mesh < m_matrix.rows(); ++mesh)
      if (entry(mesh, joint) != 0) return mesh;
    return std::nullopt;
  }
  [[nodiscard]] std::optional<int> firstJoint(MeshOrdinal mesh) const {
    const auto row = m_matrix.row(mesh);
    return row.empty() ? std::nullopt : std::optional(row.front().joint);
  }

  void fill(DualEquations& equations) const {
    for (const CoefficientMatrix::Entry& each : m_matrix.row(equations.mesh))
      equations.joints.push_back(each.joint);
    if (std::find(equations.joints.begin(), equations.joints.end(), equations.joint) ==
        equations.joints.end())
      equations.joints.push_back(equations.joint);
    std::sort(equations.joints.begin(), equations.joints.end());
    for (MeshOrdinal mesh = 0; mesh < m_matrix.rows(); ++mesh)
      if (mesh == equations.mesh || entry(mesh, equations.joint) != 0) equations.meshes.push_back(mesh);
    for (const MeshOrdinal mesh : equations.meshes) {
      std::vector<int>& row = equations.cells.emplace_back();
      for (const JointOrdinal joint : equations.joints) row.push_back(entry(mesh, joint));
    }
  }

 private:
  [[nodiscard]] int inTeeth(MeshOrdinal mesh, const CoefficientMatrix::Entry& entry) const {
    const GearMesh& gears = m_mechanism.gearMeshes[mesh];
    return entry.sign * (entry.tail ? gears.tailTeeth : gears.headTeeth);
  }

  const Mechanism& m_mechanism;
  CoefficientMatrix m_matrix;
};

std::string speedsOf(const DualEquations& equations, const Motion& motion) {
  std::string sum;
  const auto row =
      std::find(equations.meshes.begin(), equations.meshes.end(), equations.mesh) - equations.meshes.begin();
  for (std::size_t column = 0; column < equations.joints.size(); ++column) {
    const int factor = equations.cells[static_cast<std::size_t>(row)][column];
    if (factor == 0) continue;
    const Rational& speed = motion[equations.joints[column]];
    const double size = std::abs(speed.toDouble());
    addFactor(sum, (factor < 0) != (speed.sign() < 0),
              std::to_string(std::abs(factor)) + "\xC2\xB7" + shownNumber(size));
  }
  return sum + " = 0";
}

}  // namespace

std::optional<DualEquations> dualEquations(const Mechanism& mechanism, const KinematicModel& model,
                                           const Placement& placement, const StaticsReport& report,
                                           std::optional<int> joint, std::optional<int> mesh) {
  if (model.c() == 0) return std::nullopt;
  const DualityEntries dual(mechanism, model, placement);
  if (!mesh) mesh = joint ? dual.firstMesh(*joint) : std::optional(0);
  if (!mesh) return std::nullopt;
  if (!joint) joint = dual.firstJoint(*mesh);
  if (!joint) return std::nullopt;
  DualEquations equations;
  equations.mesh = *mesh;
  equations.joint = *joint;
  dual.fill(equations);
  if (report.motion) equations.speeds = speedsOf(equations, *report.motion);
  if (const auto cutset = cutsetWords(mechanism, model, placement, report, *joint)) {
    Real held;
    bool isDetermined = true;
    for (const CutsetTerm& term : cutset->terms) {
      if (term.element.kind != ElementKind::gearMesh) continue;
      held -= term.torque;
      isDetermined = isDetermined && term.isDetermined;
    }
    if (isDetermined) equations.torque = shownNumber(held.number());
  }
  return equations;
}

}  // namespace geargraph
