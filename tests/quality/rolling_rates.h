#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/machine/train/train.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::test {

/// Joint rates with which the surfaces of all meshes roll, from velocities at the pitch points alone: the
/// given rates at the first joints that can have them.
[[nodiscard]] Eigen::VectorXd rollingRates(const Mechanism& mechanism, const Placement& placement,
                                           const GearTrain& train, const std::vector<double>& wanted);

}  // namespace geargraph::test
