#pragma once

#include <memory>
#include <vector>

#include "core/theory/ttgraph/tt_solution.h"
#include "tests/core/support/trains.h"

namespace geargraph::test {

/// A mechanism with its T-T graph, for tests.
struct TtCase {
  explicit TtCase(const Mechanism& of)
      : mechanism(of),
        placement(placementOf(mechanism)),
        digraph(std::make_shared<const Digraph>(mechanism)),
        tree(std::make_shared<const SpanningTree>(SpanningTree::of(*digraph).value())),
        graph(mechanism, digraph, tree, ReferenceLines(placement)) {}

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

  /// The velocity, in the drawn pose, of the point where a mesh touches, as a point of one of its links.
  [[nodiscard]] ExactTriple velocityAt(int link, const ExactTriple& point,
                                       const std::vector<Rational>& rates) const {
    ExactTriple velocity{0, 0, 0};
    for (const PathStep& step : treePath(*tree, 0, link)) {
      const TurningJoint& joint = mechanism.turningJoints[static_cast<std::size_t>(step.joint)];
      const Axis& axis = *mechanism.find(joint.axis);
      const Rational rate = Rational(step.direction) * rates[static_cast<std::size_t>(step.joint)];
      const ExactTriple arm = point - exactOf(*axis.point);
      velocity = velocity + rate * cross(unitDirection(axis), arm);
    }
    return velocity;
  }

  /// The angular velocity of a link in the base frame.
  [[nodiscard]] ExactTriple angularVelocity(int link, const std::vector<Rational>& rates) const {
    ExactTriple velocity{0, 0, 0};
    for (const PathStep& step : treePath(*tree, 0, link)) {
      const TurningJoint& joint = mechanism.turningJoints[static_cast<std::size_t>(step.joint)];
      const Rational rate = Rational(step.direction) * rates[static_cast<std::size_t>(step.joint)];
      velocity = velocity + rate * unitDirection(*mechanism.find(joint.axis));
    }
    return velocity;
  }

  /// Do the two gears of every mesh have one velocity where they touch? Exactly; false where a point is not
  /// rational.
  [[nodiscard]] bool rollsWithoutSliding(const std::vector<Rational>& rates) const {
    for (int mesh = 0; mesh < mechanism.c(); ++mesh) {
      const auto point = exactPitchPoint(mechanism, placement, mesh);
      const DigraphEdge& edge = digraph->meshEdge(mesh);
      if (!point || velocityAt(edge.tail, *point, rates) != velocityAt(edge.head, *point, rates))
        return false;
    }
    return true;
  }

  Mechanism mechanism;
  Placement placement;
  DigraphPtr digraph;
  SpanningTreePtr tree;
  TtGraph graph;
};

}  // namespace geargraph::test
