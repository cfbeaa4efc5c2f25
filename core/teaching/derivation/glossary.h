#pragma once

#include <string_view>
#include <vector>

#include "core/mechanism/graph/paper_equation.h"

namespace geargraph {

/// The terms of the field that the program shows.
enum class Term {
  movingLinks,
  turningJoints,
  gearMeshes,
  rank,
  degreesOfFreedom,
  incidenceMatrix,
  reducedIncidenceMatrix,
  pathMatrix,
  spanningTreeMatrix,
  cycleBasisMatrix,
  cutsetMatrix,
  digraph,
  functionalSchematic,
  link,
  ground,
  turningJoint,
  gearMesh,
  input,
  axis,
  axisPoint,
  axisDirection,
  offset,
  jointLimits,
  teeth,
  module,
  meshKind,
  helixAngle,
  pitchPoint,
  gearRatio,
  spanningTree,
  cycle,
  label,
  screw,
  coefficientMatrix,
  solution,
  ttGraph,
  level,
  transferVertex,
  chord,
  terminalEquation,
  fundamentalCircuit,
  ttCircuitMatrix,
  ttCutsetMatrix,
};

struct Definition {
  Term term = Term::link;
  std::string_view symbol;                       ///< "n", "Γ⁰"; empty where the term has none
  std::string_view name;                         ///< "Moving links"
  std::string_view text;                         ///< the definition, in full sentences
  PaperEquation equation = PaperEquation::none;  ///< that defines it
};

/// The single table of definitions, used by tooltips, search and lessons. Every term once, in the order of
/// Term.
[[nodiscard]] const std::vector<Definition>& glossary();
[[nodiscard]] const Definition& definitionOf(Term term);

}  // namespace geargraph
