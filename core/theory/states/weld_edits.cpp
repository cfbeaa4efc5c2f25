#include "core/theory/states/weld_edits.h"

#include <algorithm>
#include <map>

#include "core/foundations/base/position_index.h"
#include "core/mechanism/model/link_edits.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/matroid/input_roles.h"
#include "core/theory/matroid/matroid_analysis.h"
#include "core/theory/states/engagement.h"

namespace geargraph {
namespace {

/// The train as engaged; none where it cannot be solved.
std::optional<KinematicModel> engagedTrain(const Mechanism& mechanism, const Placement& placement) {
  if (!placement.tree) return std::nullopt;
  Engagement engagement = engagementOf(mechanism, placement, engagedCouplings(mechanism));
  if (!engagement.diagnostics.empty()) return std::nullopt;
  std::optional<KinematicModel> model =
      KinematicModel::of(placement.tree->graph, placement.tree->tree, placement);
  if (model) model->hold(std::move(engagement.rows));
  return model;
}

/// The speeds of the joints under the inputs of the document; empty where there is no motion.
std::map<JointId, Rational> speedsOf(const Mechanism& mechanism) {
  const Placement placement = placementOf(mechanism);
  const std::optional<KinematicModel> model = engagedTrain(mechanism, placement);
  std::map<JointId, Rational> speeds;
  if (!model) return speeds;
  const auto analysis = analyzeMatroid(mechanism, *model, placement);
  if (!analysis->solution) return speeds;
  const auto exact = solveExact(*model, analysis->choice.joints, analysis->speeds);
  if (!exact) return speeds;  // with powers of pi: they choose their inputs anew
  for (JointOrdinal joint = 0; joint < mechanism.t(); ++joint)
    speeds.emplace(mechanism.turningJoints[joint].id, exact->rates[joint]);
  return speeds;
}

/// `after` with its inputs completed to a valid set. `twin`: a new joint, and the one whose speed it has had.
Expected<Mechanism> withValidInputs(Mechanism after, const Mechanism& before,
                                    const std::optional<std::pair<JointId, JointId>>& twin = {}) {
  if (!after.inputs) return after;
  const Placement placement = placementOf(after);
  const std::optional<KinematicModel> model = engagedTrain(after, placement);
  if (!model) return after;
  const PositionIndex<JointTag> positions(after.turningJoints);
  std::vector<int> present;
  for (const Input& input : *after.inputs) present.push_back(positions.at(input.joint));
  if (twin) present.push_back(positions.at(twin->first));  // what has come free, before anything else
  const auto joints = InputCompletion(*model).with({}, present);
  if (!joints) return after;
  const std::map<JointId, Rational> speeds = speedsOf(before);
  std::vector<Input> inputs;
  for (const JointOrdinal joint : *joints) {
    const JointId id = after.turningJoints[joint].id;
    const auto known = std::find_if(after.inputs->begin(), after.inputs->end(),
                                    [&](const Input& input) { return input.joint == id; });
    if (known != after.inputs->end()) {
      inputs.push_back(*known);
      continue;
    }
    const auto speed = speeds.find(twin && twin->first == id ? twin->second : id);
    inputs.push_back({id, Number(speed == speeds.end() ? Rational(0) : speed->second), {}});
  }
  after.inputs = std::move(inputs);
  return after;
}

}  // namespace

Expected<Mechanism> withLinksWelded(const Mechanism& mechanism, LinkId kept, LinkId other) {
  Expected<Mechanism> after = withLinksMerged(mechanism, kept, other);
  if (!after) return after;
  return withValidInputs(*std::move(after), mechanism);
}

Expected<Mechanism> withLinkDivided(const Mechanism& mechanism, LinkId link,
                                    std::span<const ElementId> moving, std::optional<CanvasPoint> at) {
  Expected<Mechanism> after = withLinkSplit(mechanism, link, moving, at);
  if (!after) return after;
  // Both parts are carried by one link; the joint that was there before has had the speed of the new one.
  const TurningJoint& made = after->turningJoints.back();
  const LinkId part = after->links.back().id;
  const auto isPart = [&](LinkId end) { return end == link || end == part; };
  const LinkId carrier = isPart(made.tail) ? made.head : made.tail;
  std::optional<std::pair<JointId, JointId>> twin;
  for (const TurningJoint& joint : after->turningJoints) {
    const bool isBeside =
        (joint.tail == carrier && isPart(joint.head)) || (joint.head == carrier && isPart(joint.tail));
    if (joint.id != made.id && isBeside) twin = {made.id, joint.id};
  }
  return withValidInputs(*std::move(after), mechanism, twin);
}

}  // namespace geargraph
