#include "core/theory/matroid/locked_loops.h"

#include <algorithm>

namespace geargraph::inline matroid {
namespace {

/// The mesh rows transposed, an unknown multiplier per mesh, and a given column per dead joint: multipliers y
/// with y P = the unit row of that joint prove that it stands still.
SparseRows<Fused> certificateRows(const KinematicModel& model, const FusedField& field,
                                  const std::vector<int>& joints) {
  const SparseRows<Fused> rows = meshRows(model, field);
  std::vector<std::vector<std::pair<int, Fused>>> equations(static_cast<std::size_t>(model.n()));
  for (int mesh = 0; mesh < rows.rows(); ++mesh) {
    for (int entry = rows.begin(mesh); entry < rows.end(mesh); ++entry) {
      equations[rows.column(entry)].emplace_back(mesh, rows.value(entry));
    }
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto& rate = model.jointRate(joints[i]);
    const int column = model.c() + static_cast<int>(i);
    equations[static_cast<std::size_t>(rate.child) - 1].emplace_back(column, field.fromInteger(-rate.sign));
    if (rate.parent != 0) {
      equations[static_cast<std::size_t>(rate.parent) - 1].emplace_back(column, field.fromInteger(rate.sign));
    }
  }
  SparseRows<Fused> result;
  for (const auto& equation : equations) {
    for (const auto& [column, value] : equation) result.add(column, value);
    result.endRow();
  }
  return result;
}

}  // namespace

std::optional<std::vector<LockedLoop>> lockedLoops(const KinematicModel& model, const FusedField& field,
                                                   const std::vector<char>& dead,
                                                   const std::stop_token& stop) {
  constexpr std::size_t kMostJoints = 200;
  std::vector<int> joints;
  for (int joint = 0; joint < model.t() && joints.size() < kMostJoints; ++joint) {
    if (dead[joint] != 0) joints.push_back(joint);
  }
  if (joints.empty()) return std::vector<LockedLoop>();
  const int columns = model.c() + static_cast<int>(joints.size());
  const auto system = eliminate(field, certificateRows(model, field, joints), model.c(), columns, stop);
  if (!system) return std::nullopt;

  std::vector<LockedLoop> certificates;
  std::vector<Fused> y(static_cast<std::size_t>(columns));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (stop.stop_requested()) return std::nullopt;
    Fused& given = y[static_cast<std::size_t>(model.c()) + i];
    given = field.one();
    substitute(field, *system, y);
    given = {};
    LockedLoop certificate{{}, {joints[i]}};
    for (int mesh = 0; mesh < model.c(); ++mesh) {
      if (!field.isZero(y[mesh])) certificate.meshes.push_back(mesh);
    }
    certificates.push_back(std::move(certificate));
  }
  std::stable_sort(certificates.begin(), certificates.end(), [](const LockedLoop& a, const LockedLoop& b) {
    return a.meshes.size() < b.meshes.size();
  });

  std::vector<LockedLoop> loops;
  for (const LockedLoop& certificate : certificates) {
    const auto within = [&](const LockedLoop& loop) {
      return std::includes(certificate.meshes.begin(), certificate.meshes.end(), loop.meshes.begin(),
                           loop.meshes.end());
    };
    const auto known = std::find_if(loops.begin(), loops.end(), within);
    if (known == loops.end()) {
      loops.push_back(certificate);
    } else if (known->meshes == certificate.meshes) {
      known->joints.push_back(certificate.joints.front());
    }
  }
  for (LockedLoop& loop : loops) std::sort(loop.joints.begin(), loop.joints.end());
  return loops;
}

}  // namespace geargraph::inline matroid
