#pragma once

#include <stdexcept>
#include <utility>

#include "core/theory/matroid/matroid_analysis.h"

namespace geargraph::test {

/// A mechanism with all that the matroid method works on. Not to be moved: parts refer to each other.
struct Worked {
  Mechanism mechanism;
  DigraphPtr graph;
  SpanningTreePtr tree;
  Placement placement;
  KinematicModel model;
  MatroidAnalysis analysis;

  explicit Worked(Mechanism of)
      : mechanism(std::move(of)),
        graph(std::make_shared<const Digraph>(mechanism)),
        tree(treeOf(*graph)),
        placement(placementOf(mechanism)),
        model(modelOf()),
        analysis(*analyzeMatroid(mechanism, model, placement)) {}
  Worked(const Worked&) = delete;
  Worked& operator=(const Worked&) = delete;

 private:
  static SpanningTreePtr treeOf(const Digraph& graph) {
    auto tree = SpanningTree::of(graph);
    if (!tree) throw std::logic_error("the joints are no tree");
    return std::make_shared<const SpanningTree>(std::move(*tree));
  }
  KinematicModel modelOf() const {
    auto made = KinematicModel::of(graph, tree, placement);
    if (!made)
      throw std::logic_error(placement.diagnostics.empty() ? "" : placement.diagnostics.front().message);
    return std::move(*made);
  }
};

}  // namespace geargraph::test
