#pragma once

#include <memory_resource>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/theory/matroid/structure.h"

namespace geargraph {

/// The rows of these equations, then one row per input, theta_input - u = 0, with the inputs' rates u as
/// given columns n, n+1, ... One elimination of them solves the mechanism and decides whether the inputs are
/// valid.
template <class Field>
[[nodiscard]] SparseRows<typename Field::Value> inputRows(
    const KinematicModel& model, const Field& field, std::span<const int> equations,
    std::span<const int> inputs, std::pmr::memory_resource* memory = std::pmr::get_default_resource()) {
  SparseRows<typename Field::Value> rows(memory);
  rows.reserve(equations.size() + inputs.size(), 4 * equations.size() + 3 * inputs.size());
  const int meshes = model.c();
  for (const int equation : equations) {
    if (equation < meshes) {
      model.addMeshRow(rows, equation, field);
    } else {
      KinematicModel::addHeldRow(rows, model.heldRow(equation), field);
    }
    rows.endRow();
  }
  const auto minus = field.fromInteger(-1);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    model.addRateRow(rows, inputs[i], field);
    rows.add(model.n() + static_cast<int>(i), minus);
    rows.endRow();
  }
  return rows;
}

/// A mechanism solved for its inputs [AU, Eqs. (22), (23)], in doubles whose zeros are exact.
struct LiveSolution {
  std::vector<int> inputs;   ///< joints, in column order
  std::vector<int> outputs;  ///< the other joints, by label
  ByJoint<double> rates;     ///< for the given speeds, rad/s, of sliding joints lengths a second
  /// theta_outputs = matrix * theta_inputs, row by row: -P_r^-1 P_E. Empty above kMaxLiveEntries.
  std::vector<double> matrix;

  int rank = 0;
  ByJoint<char> dead;  ///< it can never turn; MatroidAnalysis takes it over
  int redundant = 0;   ///< equations that depend on others

  static constexpr std::size_t kMaxLiveEntries = 2'000'000;
};

/// std::nullopt if the inputs are not valid, or `stop` was requested.
/// Cost: near linear in n + c, times E for the matrix.
/// @pre a speed for each input
[[nodiscard]] std::optional<LiveSolution> solveLive(const KinematicModel& model,
                                                    const ModularDoubleField& field,
                                                    std::span<const int> inputs,
                                                    std::span<const Rational> speeds,
                                                    const std::stop_token& stop = {});

/// 0 .. equations() - 1: the meshes and the engaged couplings.
[[nodiscard]] std::vector<int> allEquations(const KinematicModel& model);

/// The joints that are not among the inputs, by label.
[[nodiscard]] std::vector<int> outputsOf(const KinematicModel& model, std::span<const int> inputs);

/// The absolute angular velocity vector of every link in the base frame, reference pose, rad/s.
[[nodiscard]] std::vector<Vector3> linkVelocities(const KinematicModel& model, const Placement& placement,
                                                  std::span<const double> rates);

/// The relative angular velocity at each mesh, w_head - w_tail [AU, Eq. (15): -sum T u theta]. A vector: the
/// axes of two gears need not be parallel.
[[nodiscard]] std::vector<Vector3> meshVelocities(const KinematicModel& model,
                                                  const std::vector<Vector3>& links);

}  // namespace geargraph
