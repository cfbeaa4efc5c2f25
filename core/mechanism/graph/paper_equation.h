#pragma once

#include <string>

namespace geargraph {

/// The numbered equations of the paper [AU]: the one place where their numbers stand. Report, matrices,
/// lessons, the check of a user's own work and Python cite by it; tests/paper holds it against the equations
/// as they are printed.
///
/// From terminal41 on the numbers are those of the paper's robot. Other mechanisms have other numbers of
/// meshes and unknowns: EquationNumbers counts on from gearRelation for them.
enum class PaperEquation {
  none = 0,  ///< not in the paper
  incidenceMatrix = 1,
  reducedIncidenceMatrix,
  pathMatrix,
  spanningTreeMatrix,
  cycleBasisMatrix,
  screw,
  jointDirection,
  offsetRotation,
  directionComponents,
  moment,
  offsetVector,
  momentComponents,
  twist,
  twistSums,
  meshVelocities,
  momentSums,
  meshEquations,
  coefficientMatrix,
  coefficientsInNumbers,
  gearRatios,
  freedom,
  partedEquations,
  solutionByInverse,
  equationsInRatios,
  matroidSolution,
  gearRelation,
  terminal41,
  terminal52,
  terminal67,
  terminal73,
  circuit51,
  circuit62,
  circuit40,
  circuit10,
  circuit21,
  circuit72,
  secondCircuit72,
  circuit32,
  velocity10,
  velocity21,
  velocity32,
  velocity72,
  ttSolution,
  ratioNames,
  ttSolutionInGearRatios,
};

constexpr int kPaperEquations = 45;
static_assert(static_cast<int>(PaperEquation::ttSolutionInGearRatios) == kPaperEquations);

[[nodiscard]] constexpr int numberOf(PaperEquation equation) {
  return static_cast<int>(equation);
}

/// "(5)"; empty for none.
[[nodiscard]] inline std::string cited(PaperEquation equation) {
  return equation == PaperEquation::none ? std::string() : "(" + std::to_string(numberOf(equation)) + ")";
}

}  // namespace geargraph
