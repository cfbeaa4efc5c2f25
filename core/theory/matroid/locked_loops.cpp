#include "core/theory/matroid/locked_loops.h"

#include <algorithm>

namespace geargraph {
namespace {

/// The equations transposed, an unknown multiplier each, and a given column per dead joint: multipliers y
/// with y P = the unit row of that joint prove that it stands still.
SparseRows<ModularDouble> certificateRows(const KinematicModel& model, const ModularDoubleField& field,
                                          const std::vector<int>& joints) {
  const SparseRows<ModularDouble> rows = equationRows(model, field, model.equations());
  std::vector<std::vector<std::pair<int, ModularDouble>>> byLink(static_cast<std::size_t>(model.n()));
  for (int equation = 0; equation < rows.rows(); ++equation) {
    for (int entry = rows.begin(equation); entry < rows.end(equation); ++entry) {
      byLink[rows.column(entry)].emplace_back(equation, rows.value(entry));
    }
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto& rate = model.jointRate(joints[i]);
    const int column = model.equations() + static_cast<int>(i);
    byLink[static_cast<std::size_t>(rate.child) - 1].emplace_back(column, field.fromInteger(-rate.sign));
    if (rate.parent != 0) {
      byLink[static_cast<std::size_t>(rate.parent) - 1].emplace_back(column, field.fromInteger(rate.sign));
    }
  }
  SparseRows<ModularDouble> result;
  for (const auto& row : byLink) {
    for (const auto& [column, value] : row) result.add(column, value);
    result.endRow();
  }
  return result;
}

}  // namespace

std::optional<std::vector<LockedLoop>> lockedLoops(const KinematicModel& model,
                                                   const ModularDoubleField& field,
                                                   const std::vector<char>& dead,
                                                   const std::stop_token& stop) {
  constexpr std::size_t kMaxJoints = 200;
  std::vector<int> joints;
  for (JointOrdinal joint = 0; joint < model.t() && joints.size() < kMaxJoints; ++joint) {
    if (dead[joint] != 0) joints.push_back(joint);
  }
  if (joints.empty()) return std::vector<LockedLoop>();
  const int unknowns = model.equations();
  const int columns = unknowns + static_cast<int>(joints.size());
  const auto system = eliminate(field, certificateRows(model, field, joints), unknowns, columns, stop);
  if (!system) return std::nullopt;

  std::vector<LockedLoop> certificates;
  std::vector<ModularDouble> y(static_cast<std::size_t>(columns));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (stop.stop_requested()) return std::nullopt;
    ModularDouble& given = y[static_cast<std::size_t>(unknowns) + i];
    given = field.one();
    substitute(field, *system, y);
    given = {};
    LockedLoop certificate{{}, {joints[i]}};
    for (int equation = 0; equation < unknowns; ++equation) {
      if (!field.isZero(y[equation])) certificate.equations.push_back(equation);
    }
    certificates.push_back(std::move(certificate));
  }
  std::stable_sort(certificates.begin(), certificates.end(), [](const LockedLoop& a, const LockedLoop& b) {
    return a.equations.size() < b.equations.size();
  });

  std::vector<LockedLoop> loops;
  for (const LockedLoop& certificate : certificates) {
    const auto within = [&](const LockedLoop& loop) {
      return std::includes(certificate.equations.begin(), certificate.equations.end(), loop.equations.begin(),
                           loop.equations.end());
    };
    const auto known = std::find_if(loops.begin(), loops.end(), within);
    if (known == loops.end()) {
      loops.push_back(certificate);
    } else if (known->equations == certificate.equations) {
      known->joints.push_back(certificate.joints.front());
    }
  }
  for (LockedLoop& loop : loops) std::sort(loop.joints.begin(), loop.joints.end());
  return loops;
}

}  // namespace geargraph
