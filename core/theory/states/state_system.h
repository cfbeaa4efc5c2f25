#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/foundations/exact/elimination.h"
#include "core/foundations/exact/fields.h"
#include "core/theory/states/relative_speed.h"

namespace geargraph {

/// The rows of the meshes, then those of couplings, then the drive's speed as the given column n.
struct StateSystem {
  std::vector<KinematicModel::HeldRow> held;  ///< the rows of the engaged couplings
  std::optional<RelativeSpeed::Part> drive;

  /// `meshWeights(mesh, tail)`: the field's number for N_tail or N_head of the mesh, as in
  /// KinematicModel::addMeshRow(); rows whose mark in `left` is not 0 are left out.
  template <class Field, class Weights>
  [[nodiscard]] SparseRows<typename Field::Value> rows(const KinematicModel& model, const Field& field,
                                                       const Weights& meshWeights,
                                                       const std::vector<char>& left = {}) const {
    SparseRows<typename Field::Value> result;
    const auto isLeft = [&](std::size_t row) { return row < left.size() && left[row] != 0; };
    std::size_t row = 0;
    for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh, ++row) {
      if (isLeft(row)) continue;
      model.addMeshRow(result, mesh, field, meshWeights(mesh, true), meshWeights(mesh, false));
      result.endRow();
    }
    for (const KinematicModel::HeldRow& each : held) {
      if (isLeft(row++)) continue;
      KinematicModel::addHeldRow(result, each, field);
      result.endRow();
    }
    if (drive && !isLeft(row)) {
      addPart(result, *drive, field);
      result.add(model.n(), field.fromInteger(-1));
      result.endRow();
    }
    return result;
  }
};

/// The system eliminated in fractions. std::nullopt if `stop` was requested.
[[nodiscard]] inline std::optional<Elimination<Rational>> eliminated(const StateSystem& system,
                                                                     const KinematicModel& model,
                                                                     const std::stop_token& stop) {
  const RationalField field;
  const auto teeth = [&model](MeshOrdinal mesh, bool tail) -> Rational {
    return tail ? model.meshRow(mesh).tailTeeth : model.meshRow(mesh).headTeeth;
  };
  return eliminate(field, system.rows(model, field, teeth), model.n(), model.n() + (system.drive ? 1 : 0),
                   stop);
}

/// Can the drive's speed be chosen freely? `x` is set to the motion for the drive at 1 and the free phi at 0.
[[nodiscard]] inline bool driveIsFree(const Elimination<Rational>& system, std::vector<Rational>& x) {
  const RationalField field;
  x.assign(static_cast<std::size_t>(system.columns), Rational(0));
  if (system.columns == system.unknowns) return false;
  x.back() = 1;
  substitute(field, system, x);
  for (const auto& check : system.checks) {
    if (!field.isZero(checkValue(field, system, check, x))) return false;
  }
  return true;
}

}  // namespace geargraph
