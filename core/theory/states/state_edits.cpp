#include "core/theory/states/state_edits.h"

#include <algorithm>
#include <optional>

#include "core/foundations/base/position_index.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/theory/matroid/exact_solution.h"
#include "core/theory/matroid/input_roles.h"
#include "core/theory/matroid/matroid_analysis.h"
#include "core/theory/states/engagement.h"
#include "core/theory/states/state_solution.h"

namespace geargraph {
namespace {

/// A joint that is driven first, and how fast.
struct FirstInput {
  JointOrdinal joint = 0;
  std::optional<Rational> speed;  ///< none: as it is
};

/// The drive's own joint, or the first that turns with it.
std::optional<FirstInput> firstInputOf(const Mechanism& mechanism, const Placement& placement,
                                       const StateSolution& solution) {
  const std::optional<LinkId>& drive = mechanism.states[static_cast<std::size_t>(solution.state)].drive;
  if (!drive || !solution.driveTurns) return std::nullopt;
  const PositionIndex<LinkTag> links(mechanism.links);
  const int own = placement.tree->joint[links.at(*drive)];
  if (!solution.isSolved() || solution.isIdle(own)) return FirstInput{own, std::nullopt};
  const auto rateOf = [&](JointOrdinal joint) { return solution.rates[joint]; };
  if (!rateOf(own).isZero()) return FirstInput{own, rateOf(own)};
  for (JointOrdinal joint = 0; joint < mechanism.t(); ++joint) {
    if (!rateOf(joint).isZero() && !solution.isIdle(joint)) return FirstInput{joint, rateOf(joint)};
  }
  return std::nullopt;
}

/// Changes what is engaged in one mechanism, and its inputs with it.
class EngagementEdit {
 public:
  explicit EngagementEdit(const Mechanism& before) : m_before(before), m_placement(placementOf(before)) {
    if (m_placement.tree)
      m_train = KinematicModel::of(m_placement.tree->graph, m_placement.tree->tree, m_placement);
  }

  /// @pre `after` differs from the mechanism before in what is engaged only
  [[nodiscard]] Expected<Mechanism> finished(Mechanism after, int state = -1) const {
    if (!m_train) return after;
    Engagement engagement =
        engagementOf(after, m_placement, engagedCouplings(after),
                     state < 0 ? nullptr : &after.states[static_cast<std::size_t>(state)]);
    if (!engagement.diagnostics.empty()) return engagement.diagnostics;
    std::optional<FirstInput> first;
    if (state >= 0) {
      const auto solution = solveState(after, *m_train, m_placement, state, false);
      for (const StateSolution::Freewheel& each : solution->freewheels) {
        if (each.isLocked) after.engaged.push_back(after.couplings[each.coupling].id);
      }
      if (!solution->freewheels.empty())
        engagement = engagementOf(after, m_placement, engagedCouplings(after));
      first = firstInputOf(after, m_placement, *solution);
    }
    if (!first && !after.inputs) return after;
    KinematicModel model = *m_train;
    if (!engagement.diagnostics.empty()) return engagement.diagnostics;
    model.hold(std::move(engagement.rows));
    if (auto inputs = inputsOf(model, first)) after.inputs = std::move(inputs);
    return after;
  }

 private:
  /// The joints that are driven before, with the motion that they make.
  struct Motion {
    std::vector<int> driven;
    ByJoint<Rational> rates;  ///< empty where there is none
  };

  [[nodiscard]] Motion motionBefore() const {
    KinematicModel model = *m_train;
    model.hold(engagementOf(m_before, m_placement, engagedCouplings(m_before)).rows);
    const auto analysis = analyzeMatroid(m_before, model, m_placement);
    Motion motion{analysis->choice.joints, {}};
    if (!analysis->solution) return motion;
    if (auto exact = solveExact(model, motion.driven, analysis->speeds))
      motion.rates = std::move(exact->rates);
    return motion;
  }

  [[nodiscard]] std::optional<std::vector<Input>> inputsOf(const KinematicModel& model,
                                                           const std::optional<FirstInput>& first) const {
    const Motion motion = motionBefore();
    std::vector<int> wanted;
    if (first) wanted.push_back(first->joint);
    const auto joints = InputCompletion(model).with(wanted, motion.driven);
    if (!joints) return std::nullopt;
    std::vector<Input> inputs;
    for (const JointOrdinal joint : *joints) {
      const JointId id = m_before.turningJoints[joint].id;
      if (first && first->joint == joint && first->speed) {
        inputs.push_back({id, Number(*first->speed), {}});
      } else if (const Input* known = inputBefore(id)) {
        inputs.push_back(*known);
      } else {
        const bool moves = !motion.rates.empty();
        inputs.push_back({id, Number(moves ? motion.rates[joint] : Rational(1)), {}});
      }
    }
    return inputs;
  }

  [[nodiscard]] const Input* inputBefore(JointId joint) const {
    if (!m_before.inputs) return nullptr;
    const auto found = std::find_if(m_before.inputs->begin(), m_before.inputs->end(),
                                    [&](const Input& input) { return input.joint == joint; });
    return found == m_before.inputs->end() ? nullptr : &*found;
  }

  const Mechanism& m_before;
  Placement m_placement;
  std::optional<KinematicModel> m_train;  ///< without couplings; none where it cannot be solved
};

}  // namespace

Expected<Mechanism> withCouplingsEngaged(Mechanism mechanism, const std::vector<ShiftElementId>& engaged) {
  Expected<Mechanism> after = withEngagement(mechanism, engaged);
  if (!after || after->engaged == mechanism.engaged) return after;
  return EngagementEdit(mechanism).finished(*std::move(after));
}

Expected<Mechanism> withCouplingEngaged(Mechanism mechanism, ShiftElementId coupling, bool engaged) {
  std::vector<ShiftElementId> all = mechanism.engaged;
  std::erase(all, coupling);
  if (engaged || mechanism.find(coupling) == nullptr) all.push_back(coupling);  // an unknown one is rejected
  return withCouplingsEngaged(std::move(mechanism), all);
}

Expected<Mechanism> withStateEngaged(Mechanism mechanism, int state) {
  std::vector<ShiftElementId> engaged = mechanism.states[static_cast<std::size_t>(state)].engaged;
  std::sort(engaged.begin(), engaged.end());
  engaged.erase(std::unique(engaged.begin(), engaged.end()), engaged.end());
  Expected<Mechanism> after = withEngagement(mechanism, engaged);
  if (!after) return after;
  return EngagementEdit(mechanism).finished(*std::move(after), state);
}

}  // namespace geargraph
