#include "core/teaching/exercises/link_gears.h"

#include <algorithm>

#include "core/theory/matroid/coefficient_matrix.h"
#include "core/theory/ttgraph/notation.h"

namespace geargraph {
namespace {

void addGears(NumberSymbols& symbols, const std::string& label, const std::vector<LinkGear>& gears) {
  const auto isOne = [&](auto value) {
    return std::all_of(gears.begin(), gears.end(),
                       [&](const LinkGear& gear) { return value(gear) == value(gears.front()); });
  };
  const auto teeth = [](const LinkGear& gear) { return gear.teeth; };
  const auto diameter = [](const LinkGear& gear) { return gear.diameter; };
  std::string primes;
  for (const LinkGear& gear : gears) {
    if (primes.empty() && isOne(teeth)) symbols.emplace("N" + label, std::to_string(gear.teeth));
    if (primes.empty() && gear.diameter && isOne(diameter))
      symbols.emplace("d" + label, gear.diameter->toString());
    primes += '\'';
    symbols.emplace("N" + label + primes, std::to_string(gear.teeth));
    if (gear.diameter) symbols.emplace("d" + label + primes, gear.diameter->toString());
  }
}

}  // namespace

std::vector<LinkGear> gearsOfLink(const ExerciseSource& source, int label) {
  std::vector<LinkGear> gears;
  const Digraph& graph = source.graph();
  for (MeshOrdinal mesh = 0; mesh < graph.c(); ++mesh) {
    const DigraphEdge& ends = graph.meshEdge(mesh);
    const GearMesh& teeth = source.mechanism().gearMeshes[mesh];
    for (const bool isTail : {true, false}) {
      if (graph.nodeLabel(isTail ? ends.tail : ends.head) != label) continue;
      LinkGear gear{isTail ? teeth.tailTeeth : teeth.headTeeth, {}};
      if (source.matroid() != nullptr) {
        const LiveKinematics& live = *source.snapshot()->kinematics;
        const CoefficientMatrix coefficients(source.mechanism(), *live.model, live.placement());
        if (const auto radius = coefficients.exactRadius(mesh, isTail)) gear.diameter = *radius * 2;
      }
      gears.push_back(gear);
    }
  }
  return gears;
}

NumberSymbols numberSymbols(const ExerciseSource& source) {
  NumberSymbols symbols;
  const Digraph& graph = source.graph();
  const std::vector<RatioNames> names = ratioNames(graph);
  for (MeshOrdinal mesh = 0; mesh < graph.c(); ++mesh) {
    const GearMesh& teeth = source.mechanism().gearMeshes[mesh];
    const RatioNames& ratio = names[static_cast<std::size_t>(mesh)];
    const Rational value(teeth.tailTeeth, teeth.headTeeth);
    symbols.emplace(ratio.matroid, value.toString());
    symbols.emplace(ratio.ttGraph, value.toString());
    symbols.emplace(ratio.inverse, value.inverse().toString());
  }
  for (LinkOrdinal node = 0; node < graph.nodeCount(); ++node)
    addGears(symbols, source.linkLabel(node), gearsOfLink(source, graph.nodeLabel(node)));
  return symbols;
}

}  // namespace geargraph
