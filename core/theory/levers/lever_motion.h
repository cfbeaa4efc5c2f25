#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/theory/levers/lever_plan.h"

namespace geargraph {

/// The speeds of the links of the main axis about its line, by position in LeverPlan::links, from the rates
/// of all joints. Exact.
/// Identity  on each lever they are an affine function of the place: speedAt().
/// Cost: O(links, times the joints to the ground). @pre plan and placement are of one mechanism
[[nodiscard]] std::vector<Rational> leverSpeeds(const LeverPlan& plan, const Placement& placement,
                                                std::span<const Rational> rates);

/// The speed at a place of a lever, between and beyond its points.
[[nodiscard]] Rational speedAt(const LeverPlan& plan, const Lever& lever, std::span<const Rational> speeds,
                               const Rational& place);

/// The speeds of the links of the main axis from those of the plan's basis.
/// @pre one speed for each link of the basis
[[nodiscard]] std::vector<Rational> speedsFromBasis(const LeverPlan& plan, std::span<const Rational> speeds);

}  // namespace geargraph
