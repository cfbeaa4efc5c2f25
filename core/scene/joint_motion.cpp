#include "core/scene/joint_motion.h"

#include <algorithm>
#include <numbers>

#include "core/base/contract.h"
#include "core/pose/period.h"
#include "core/ttgraph/tt_solution.h"

namespace geargraph {
namespace {

/// Positions of the inputs' joints; nothing where the document names none, or one twice.
std::optional<std::vector<int>> inputJoints(const Mechanism& mechanism) {
  if (!mechanism.inputs) return std::nullopt;
  std::vector<int> joints;
  for (const Input& input : *mechanism.inputs) {
    const auto found = std::find_if(mechanism.turningJoints.begin(), mechanism.turningJoints.end(),
                                    [&](const TurningJoint& joint) { return joint.id == input.joint; });
    const int joint = static_cast<int>(found - mechanism.turningJoints.begin());
    if (std::find(joints.begin(), joints.end(), joint) != joints.end()) return std::nullopt;
    joints.push_back(joint);
  }
  return joints;
}

}  // namespace

void JointMotion::angles(std::span<const double> inputAngles, std::span<double> jointAngles) const {
  GEARGRAPH_REQUIRE(inputAngles.size() == inputs.size() &&
                    jointAngles.size() * inputs.size() == gains.size());
  for (std::size_t joint = 0; joint < jointAngles.size(); ++joint) {
    jointAngles[joint] = 0;
    for (std::size_t k = 0; k < inputs.size(); ++k)
      jointAngles[joint] += gains[joint * inputs.size() + k] * inputAngles[k];
  }
}

std::optional<JointMotion> jointMotion(const Mechanism& mechanism, const DigraphPtr& graph,
                                       const SpanningTreePtr& tree, const Placement& placement) {
  const auto inputs = inputJoints(mechanism);
  if (!inputs || inputs->empty()) return std::nullopt;
  const TtGraph ttGraph(mechanism, graph, tree, referenceLines(placement));
  if (!ttGraph.isComplete()) return std::nullopt;
  const SubstitutionPlan plan = substitutionPlan(ttGraph, *inputs);
  const auto determination = ttDetermination(ttGraph, plan);
  if (!determination || !determination->valid()) return std::nullopt;
  const auto solution = ttSolution(ttGraph, plan);
  if (!solution) return std::nullopt;

  JointMotion motion;
  motion.inputs = *inputs;
  const std::size_t columns = inputs->size();
  motion.gains.assign(static_cast<std::size_t>(graph->t()) * columns, 0);
  std::vector<Rational> rates(static_cast<std::size_t>(graph->t()));
  for (std::size_t k = 0; k < columns; ++k) {
    const auto joint = static_cast<std::size_t>(motion.inputs[k]);
    const Rational& speed = (*mechanism.inputs)[k].speed.exact();
    motion.speeds.push_back(speed.toDouble());
    motion.gains[joint * columns + k] = 1;
    rates[joint] = speed;
    for (std::size_t row = 0; row < solution->outputs.size(); ++row) {
      const auto output = static_cast<std::size_t>(solution->outputs[row]);
      motion.gains[output * columns + k] = solution->entries[row][k].toDouble();
      rates[output] += solution->entries[row][k] * speed;
    }
  }
  if (const auto turns = commonPeriod(rates)) motion.period = 2 * std::numbers::pi * turns->toDouble();
  return motion;
}

}  // namespace geargraph
