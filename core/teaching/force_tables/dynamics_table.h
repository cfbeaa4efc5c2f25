#pragma once

#include <optional>
#include <string>

#include "core/teaching/force_tables/force_table.h"
#include "core/theory/dynamics/dynamics_report.h"

namespace geargraph {

/// The dynamics of a mechanism at one pose and speed of its inputs.
struct DynamicState {
  EquationOfMotion equation;
  Eigen::MatrixXd reflected;  ///< TrainDynamics::reflectedInertias()
};

/// The masses of the moving links: one row per link, in the order of the document. Lengths in the document's
/// unit.
enum class MassColumn { link, mass, centerX, centerY, centerZ, inertiaX, inertiaY, inertiaZ, source, count };
/// `metres`: in one of the document's unit. @pre an inertia for each link
[[nodiscard]] ValueTable massTable(const Mechanism& mechanism, std::span<const LinkInertia> links,
                                   double metres);

/// The inertia of each link reflected to each motor: one row per link, one column per input; the sums last.
[[nodiscard]] ValueTable reflectedTable(const Mechanism& mechanism, const MechanismDynamics& dynamics,
                                        const DynamicState& state);

/// M theta'' + h = tau + load: one row per input; its row of M, then h, the load, and the torque for constant
/// speeds, h - load.
[[nodiscard]] ValueTable equationTable(const Mechanism& mechanism, const MechanismDynamics& dynamics,
                                       const DynamicState& state);
/// The equation in TeX, with its numbers as matrices; empty for more than kMaxTypesetInputs inputs.
[[nodiscard]] std::string equationTex(const Mechanism& mechanism, const MechanismDynamics& dynamics,
                                      const DynamicState& state);
constexpr int kMaxTypesetInputs = 6;

/// The source of a link's mass in words: "from its solids", "stated", ...
[[nodiscard]] std::string massSourceText(MassSource source);

/// A number in TeX with this many digits: "0.0123", "1.5\cdot 10^{-7}".
[[nodiscard]] std::string texNumber(double value, int digits = 4);

}  // namespace geargraph
