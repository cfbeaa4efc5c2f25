#include "core/teaching/exercises/exercise_statics.h"

#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

const KinematicModel& modelOf(const ExerciseSource& source) {
  return *source.snapshot()->kinematics->model;
}
const Placement& placementOf(const ExerciseSource& source) {
  return source.snapshot()->kinematics->placement();
}

RadicalColumns loadsOf(const ExerciseSource& source, const StaticsProblem& problem) {
  return LoadPower::of(source.mechanism(), modelOf(source), placementOf(source), problem).byLink;
}

/// The solution without losses, if it has one that is determined and exact.
std::optional<StaticsSolution> losslessOf(const ExerciseSource& source, const StaticsProblem& problem) {
  auto held = heldParts(source.mechanism(), modelOf(source), placementOf(source), problem);
  auto solution = solveStatics(modelOf(source), std::move(held), loadsOf(source, problem));
  GEARGRAPH_REQUIRE(solution.has_value());
  if (!solution->isBalanced() || !solution->isDeterminate()) return std::nullopt;
  const bool isExact = std::all_of(solution->values.begin(), solution->values.end(),
                                   [](const Real& value) { return value.isExact(); });
  if (!isExact) return std::nullopt;
  return std::move(*solution);
}

/// 1 N m on the drive of a state, a balance on its driven link; none where one of them is the ground.
std::optional<StaticsProblem> problemOf(const ExerciseSource& source, int state) {
  const ShiftState& asked = source.mechanism().states[static_cast<std::size_t>(state)];
  const int drive = source.graph().nodeOf(*asked.drive);
  const int driven = source.graph().nodeOf(*asked.driven);
  if (drive == 0 || driven == 0 || drive == driven) return std::nullopt;
  const auto place = [&](LinkOrdinal link) {
    return onLink(source.mechanism(), placementOf(source), link, std::nullopt);
  };
  StaticsProblem problem;
  problem.torques = {{place(drive), 1}};
  problem.balances = {place(driven)};
  problem.engaged = source.engagedSets(state)[*source.setOfState(state)].couplings;
  return problem;
}

std::vector<int> rollingMeshes(const ExerciseSource& source, const Motion& motion) {
  const ByLink<Rational> phi = phiOf<Rational>(modelOf(source), motion);
  std::vector<int> rolling;
  for (MeshOrdinal mesh = 0; mesh < source.graph().c(); ++mesh) {
    const auto& links = modelOf(source).meshRow(mesh).links;
    if (phi[links[0]] != phi[links[1]]) rolling.push_back(mesh);
  }
  return rolling;
}

std::vector<DrivenTrain> trainsOfStates(const ExerciseSource& source) {
  std::vector<DrivenTrain> trains;
  for (const int state : statesWithRatio(source)) {
    const auto problem = problemOf(source, state);
    if (!problem) continue;
    const ShiftState& asked = source.mechanism().states[static_cast<std::size_t>(state)];
    const StateSolution& solution = source.engagedSets(state)[*source.setOfState(state)].solution;
    trains.push_back({state, source.graph().nodeOf(*asked.drive), source.graph().nodeOf(*asked.driven),
                      solution.rates, *problem, rollingMeshes(source, solution.rates)});
  }
  return trains;
}

/// Each input with each joint on the ground that it turns, the other inputs held.
std::vector<DrivenTrain> trainsOfInputs(const ExerciseSource& source) {
  std::vector<DrivenTrain> trains;
  for (std::size_t input = 0; input < source.inputs().size(); ++input) {
    Motion motion;
    for (const auto& rates : source.rates()) motion.push_back(rates[input]);
    const std::vector<int> rolling = rollingMeshes(source, motion);
    for (const JointOrdinal joint : predictableJoints(source)) {
      const bool isOnGround = source.tree()->parent(source.tree()->child(joint)) == 0;
      if (!isOnGround || motion[joint].isZero()) continue;
      DrivenTrain train{-1, source.inputs()[input], joint, motion, {}, rolling};
      train.problem.torques = {{TorquePlace{train.drive}, 1}};
      train.problem.balances = {TorquePlace{joint}};
      for (const int other : source.inputs())
        if (other != train.drive) train.problem.balances.push_back(TorquePlace{other});
      trains.push_back(std::move(train));
    }
  }
  return trains;
}

/// What the train passes with its drive's torque at 1 N m (or -1: driven backwards), in fractions.
struct Passed {
  std::optional<Rational> efficiency;  ///< none where it locks itself
  ByMesh<MeshLoss> losses;
};

std::optional<Passed> passedBy(const ExerciseSource& source, const DrivenTrain& train, int drive,
                               std::span<const MeshEfficiency> efficiencies) {
  StaticsProblem problem = train.problem;
  problem.torques.front().torque = drive;
  const auto lossless = losslessOf(source, problem);
  if (!lossless) return std::nullopt;
  const RadicalColumns loads = loadsOf(source, problem);
  const auto lossy = solveWithLosses(modelOf(source), *lossless, loads, train.motion, efficiencies);
  GEARGRAPH_REQUIRE(lossy.has_value());
  if (lossy->outcome == LossySolution::Outcome::selfLocking) return Passed{};
  if (lossy->outcome != LossySolution::Outcome::solved) return std::nullopt;
  const PowerSums sums = powerSums(modelOf(source), *lossy, std::span(&loads, 1), train.motion);
  const auto efficiency = sums.efficiency();
  if (!efficiency || !efficiency->fraction()) return std::nullopt;
  return Passed{*efficiency->fraction(), lossy->losses};
}

}  // namespace

std::optional<StateTorques> stateTorques(const ExerciseSource& source, int state) {
  const std::vector<int> askable = statesWithRatio(source);
  if (std::find(askable.begin(), askable.end(), state) == askable.end()) return std::nullopt;
  const auto problem = problemOf(source, state);
  const auto solution = problem ? losslessOf(source, *problem) : std::nullopt;
  if (!solution) return std::nullopt;
  StateTorques torques{state, *source.engagedSets(state)[*source.setOfState(state)].solution.ratio, {}, 0};
  torques.couplings.resize(source.mechanism().couplings.size());
  for (std::size_t part = 0; part < solution->held.size(); ++part) {
    const HeldPart& held = solution->held[part];
    if (!held.isMain) return std::nullopt;
    const Rational& value = *solution->values[static_cast<std::size_t>(source.graph().c()) + part].fraction();
    if (held.coupling >= 0) {
      torques.couplings[held.coupling] = value;
    } else {
      torques.driven = value;
    }
  }
  return torques;
}

std::vector<DrivenTrain> drivenTrains(const ExerciseSource& source) {
  std::vector<DrivenTrain> all =
      source.mechanism().states.empty() ? trainsOfInputs(source) : trainsOfStates(source);
  std::vector<DrivenTrain> trains;
  for (DrivenTrain& train : all) {
    if (train.rolling.empty() || static_cast<int>(train.rolling.size()) > kMaxRollingMeshes) continue;
    const auto efficiency = efficiencyOf(source, train, Rational(99, 100));
    if (efficiency && efficiency->forward) trains.push_back(std::move(train));
  }
  return trains;
}

std::optional<TrainEfficiency> efficiencyOf(const ExerciseSource& source, const DrivenTrain& train,
                                            const Rational& meshEfficiency) {
  const auto lossless = losslessOf(source, train.problem);
  if (!lossless) return std::nullopt;
  TrainEfficiency result;
  const MeshPowers powers = powersOf(modelOf(source), *lossless, train.motion);
  for (const MeshOrdinal mesh : train.rolling) {
    const Real& power = powers.mesh[static_cast<std::size_t>(mesh)];
    if (power.isZero()) continue;
    result.passing.push_back(mesh);
    result.latent += *power.abs().fraction();
  }
  const Real fed = powerOf(modelOf(source), loadsOf(source, train.problem), train.motion);
  if (result.passing.empty() || !fed.fraction() || fed.sign() <= 0) return std::nullopt;
  result.latent = result.latent / *fed.fraction();
  const std::vector<MeshEfficiency> efficiencies(static_cast<std::size_t>(source.graph().c()),
                                                 MeshEfficiency{meshEfficiency, true, true});
  const auto forward = passedBy(source, train, 1, efficiencies);
  const auto backward = passedBy(source, train, -1, efficiencies);
  if (!forward || !backward) return std::nullopt;
  result.forward = forward->efficiency;
  result.backward = backward->efficiency;
  result.drivers = backward->losses;
  return result;
}

}  // namespace geargraph
