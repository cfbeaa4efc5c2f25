#pragma once

#include <memory>
#include <stdexcept>

#include "core/machine/body_layout/complete_train.h"
#include "core/theory/dynamics/dynamics_report.h"
#include "tests/core/support/matroid_fixture.h"

namespace geargraph::test {

/// A mechanism with its dynamics.
struct DynamicsCase : Worked {
  GearTrain gears;
  MechanismDynamics dynamics;

  explicit DynamicsCase(Mechanism of)
      : Worked(std::move(of)), gears(trainOf(mechanism, placement)), dynamics(made()) {}

  [[nodiscard]] Eigen::Index inputs() const { return dynamics.train.inputs(); }
  [[nodiscard]] Eigen::VectorXd zeros() const { return Eigen::VectorXd::Zero(inputs()); }
  [[nodiscard]] SimulationOptions options() const {
    SimulationOptions options;
    options.motors.resize(static_cast<std::size_t>(inputs()));
    options.angles = zeros();
    options.speeds = zeros();
    return options;
  }

 private:
  MechanismDynamics made() const {
    auto result = dynamicsOf(mechanism, model, placement, analysis, gears);
    if (!result || !*result) throw std::logic_error("no dynamics");
    return std::move(**result);
  }
};

inline Number number(double value) {
  return Number::fromDouble(value);
}
inline NumberTriple triple(double x, double y, double z) {
  return {number(x), number(y), number(z)};
}

/// A mass with moments of inertia along the axes of the base frame.
inline LinkMass massOf(double mass, const NumberTriple& center, double xx, double yy, double zz) {
  return {number(mass), center, InertiaNumbers{number(xx), number(yy), number(zz), 0, 0, 0}};
}

}  // namespace geargraph::test
