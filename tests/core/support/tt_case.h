#pragma once

#include <memory>
#include <vector>

#include "core/ttgraph/tt_solution.h"

namespace geargraph::test {

/// A mechanism with its T-T graph, for tests.
struct TtCase {
  explicit TtCase(const Mechanism& of)
      : mechanism(of),
        placement(placementOf(mechanism)),
        digraph(std::make_shared<const Digraph>(mechanism)),
        tree(std::make_shared<const SpanningTree>(SpanningTree::of(*digraph).value())),
        graph(mechanism, digraph, tree, referenceLines(placement)) {}

  /// The document's inputs, by ordinal.
  [[nodiscard]] std::vector<int> inputs() const {
    std::vector<int> ordinals;
    for (const Input& input : *mechanism.inputs) {
      for (int joint = 0; joint < mechanism.t(); ++joint) {
        if (mechanism.turningJoints[static_cast<std::size_t>(joint)].id == input.joint)
          ordinals.push_back(joint);
      }
    }
    return ordinals;
  }
  [[nodiscard]] std::vector<Rational> speeds() const {
    std::vector<Rational> speeds;
    for (const Input& input : *mechanism.inputs) speeds.push_back(input.speed.exact());
    return speeds;
  }
  /// Some valid inputs: what no equation gives.
  [[nodiscard]] std::vector<int> someInputs() const {
    return ttDetermination(graph, substitutionPlan(graph, {})).value().openJoints;
  }

  Mechanism mechanism;
  Placement placement;
  DigraphPtr digraph;
  SpanningTreePtr tree;
  TtGraph graph;
};

}  // namespace geargraph::test
