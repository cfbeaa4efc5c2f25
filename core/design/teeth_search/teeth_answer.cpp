#include "core/design/teeth_search/teeth_answer.h"

#include <algorithm>
#include <numeric>

#include "core/design/teeth_search/wished_states.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/statics/shift_statics.h"

namespace geargraph {
namespace {

/// The efficiencies of a train under a torque at the drive.
struct ChoiceEfficiency {
  std::optional<double> forward;
  std::optional<double> backward;
};

void lower(std::optional<double>& least, const std::optional<double>& value, bool isFirst) {
  if (isFirst || (least && value && *value < *least)) {
    least = value;
  } else if (!value) {
    least.reset();
  }
}

bool hasLosses(const TeethProblem& problem) {
  const Mechanism& train = problem.train;
  if (problem.wish.efficiency.sign() > 0) return true;
  if (train.gearDefaults && (train.gearDefaults->efficiency || train.gearDefaults->friction)) return true;
  return std::any_of(train.gearMeshes.begin(), train.gearMeshes.end(),
                     [](const GearMesh& mesh) { return mesh.efficiency || mesh.friction; });
}

/// The smallest efficiencies of the wished ratios; none where one of them is not known or locks itself.
ChoiceEfficiency efficiencyOf(const TeethProblem& problem, std::span<const int> teeth,
                              const std::stop_token& stop) {
  const auto fitted = withAllTeethFitted(problem.drawn, meshTeethOf(problem, teeth));
  if (!fitted) return {};
  auto train = std::make_shared<const Mechanism>(withWishedStates(fitted->mechanism(), problem.wish));
  const SnapshotPtr snapshot = analyzeLive(std::move(train), 0, stop);
  if (!snapshot || snapshot->matroid() == nullptr) return {};
  StaticsOptions options;
  options.documentLoads = false;
  options.losses = true;
  options.symbolic = false;
  options.driveTorque = Rational(1);
  if (problem.wish.efficiency.sign() > 0) options.efficiency = problem.wish.efficiency;
  ChoiceEfficiency least;
  for (std::size_t i = 0; i < problem.ratios.size(); ++i) {
    const auto solved = solveShiftState(*snapshot->mechanism, *snapshot->kinematics->model,
                                        snapshot->kinematics->placement(), *snapshot->kinematics->ttGraph,
                                        *snapshot->matroid(), static_cast<int>(i), options, stop);
    if (!solved || !solved->report) return {};
    const StaticsReport& report = solved->ofEfficiency();
    const auto of = [](const std::optional<LossySolution>& lossy, const std::optional<PowerSums>& sums) {
      const bool isSolved = lossy && lossy->outcome == LossySolution::Outcome::solved && sums;
      const auto value = isSolved ? sums->efficiency() : std::nullopt;
      return value ? std::optional(value->number()) : std::nullopt;
    };
    lower(least.forward, of(report.lossy, report.sums), i == 0);
    lower(least.backward, of(report.backward, report.backwardSums), i == 0);
  }
  return least;
}

std::vector<int> planetNumbers(const TeethProblem& problem, std::span<const int> teeth) {
  std::vector<int> numbers;
  const auto isSet = [](const PlanetCondition& set) { return !set.wheels().empty(); };
  if (std::none_of(problem.planets.begin(), problem.planets.end(), isSet)) return numbers;
  for (int planets = 2; planets <= kMaxPlanetsTold; ++planets) {
    if (std::all_of(problem.planets.begin(), problem.planets.end(), [&](const PlanetCondition& set) {
          return !isSet(set) || (set.clears(teeth, planets) && set.assembles(teeth, planets));
        }))
      numbers.push_back(planets);
  }
  return numbers;
}

/// Is there a choice that meets these wishes, and everything else? std::nullopt if `stop` was requested.
std::optional<bool> canMeet(const TeethProblem& problem, const std::vector<int>& wishes,
                            const TeethSearchOptions& options, const std::stop_token& stop) {
  TeethProblem part = problem;
  part.ratios.clear();
  for (const int wish : wishes) part.ratios.push_back(problem.ratios[static_cast<std::size_t>(wish)]);
  std::stop_source first;  // the first choice is enough
  const std::stop_callback passOn(stop, [&] { first.request_stop(); });
  bool found = false;
  TeethSearchOptions asked;
  asked.most = 1;
  asked.accepts = [&](std::span<const int> teeth) {
    found = found || !options.accepts || options.accepts(teeth);
    if (found) first.request_stop();
    return found;
  };
  static_cast<void>(searchTeeth(part, asked, first.get_token()));
  if (!found && stop.stop_requested()) return std::nullopt;
  return found;
}

std::vector<std::vector<int>> conflictsOf(const TeethProblem& problem, const TeethSearchOptions& options,
                                          const std::stop_token& stop) {
  std::vector<std::vector<int>> conflicts;
  const auto count = static_cast<int>(problem.ratios.size());
  const auto ask = [&](std::vector<int> wishes) {
    const auto met = canMeet(problem, wishes, options, stop);
    if (met && !*met) conflicts.push_back(std::move(wishes));
    return met.has_value();
  };
  for (int one = 0; one < count; ++one) {
    if (!ask({one})) return {};
  }
  if (!conflicts.empty() || count == 2)
    return conflicts.empty() ? std::vector<std::vector<int>>{{0, 1}} : conflicts;
  for (int one = 0; one < count; ++one) {
    for (int other = one + 1; other < count; ++other) {
      if (!ask({one, other})) return {};
    }
  }
  return conflicts;
}

std::string wishText(const TeethProblem& problem, int wish) {
  const Rational& wanted = problem.ratios[static_cast<std::size_t>(wish)].bounds.wanted;
  return translated("ratio %1 (%2)", {std::to_string(wish + 1), readableNumber(wanted)});
}

}  // namespace

std::vector<std::string> conflictSentences(const TeethAnswer& answer) {
  std::vector<std::string> sentences;
  for (const std::vector<int>& conflict : answer.conflicts) {
    const std::string one = wishText(*answer.problem, conflict.front());
    sentences.push_back(conflict.size() == 1 ? translated("No choice within the limits has %1.", {one})
                                             : translated("No choice within the limits has both %1 and %2.",
                                                          {one, wishText(*answer.problem, conflict.back())}));
  }
  return sentences;
}

TeethChoice choiceOf(const TeethProblem& problem, FoundTeeth found, const std::stop_token& stop) {
  TeethChoice choice;
  choice.found = std::move(found);
  const std::vector<int>& teeth = choice.found.teeth;
  choice.teeth = meshTeethOf(problem, teeth);
  choice.planets = planetNumbers(problem, teeth);
  for (const MeshTeeth& each : choice.teeth)
    choice.hunting.push_back(std::gcd(each.tailTeeth, each.headTeeth) == 1 ? 1 : 0);
  for (std::size_t wheel = 0; wheel < teeth.size(); ++wheel) {
    const SearchedWheel& of = problem.wheels[wheel];
    if (of.isUndercutWith(teeth[wheel])) choice.undercut.push_back(of.name);
  }
  if (hasLosses(problem)) {
    const ChoiceEfficiency efficiency = efficiencyOf(problem, teeth, stop);
    choice.efficiency = efficiency.forward;
    choice.backward = efficiency.backward;
  }
  return choice;
}

Expected<TeethAnswer> teethFor(const PlacedMechanism& drawn, const TeethWish& wish,
                               const TeethSearchOptions& options, const std::stop_token& stop) {
  auto made = teethProblemOf(drawn, wish);
  if (!made) return made.error();
  TeethAnswer answer;
  answer.problem = std::make_shared<const TeethProblem>(*std::move(made));
  const TeethProblem& problem = *answer.problem;
  TeethSearchOptions asked = options;
  if (wish.leastEfficiency.sign() > 0 && !options.accepts) {
    const double least = wish.leastEfficiency.toDouble();
    asked.accepts = [&problem, least, &stop](std::span<const int> teeth) {
      const ChoiceEfficiency efficiency = efficiencyOf(problem, teeth, stop);
      return efficiency.forward && *efficiency.forward >= least;
    };
  }
  answer.found = searchTeeth(problem, asked, stop);
  for (const FoundTeeth& best : answer.found.best) answer.choices.push_back(choiceOf(problem, best, stop));
  // Of equally good ones that which loses less, with an unknown efficiency last.
  std::stable_sort(answer.choices.begin(), answer.choices.end(),
                   [](const TeethChoice& one, const TeethChoice& other) {
                     if (one.found.error != other.found.error) return one.found.error < other.found.error;
                     return one.efficiency.value_or(-1) > other.efficiency.value_or(-1);
                   });
  if (answer.found.isComplete && answer.found.counts.accepted == 0 && problem.ratios.size() > 1)
    answer.conflicts = conflictsOf(problem, asked, stop);
  if (answer.found.nearest) answer.nearest = choiceOf(problem, *answer.found.nearest, stop);
  return answer;
}

std::vector<MeshTeeth> meshTeethOf(const TeethProblem& problem, std::span<const int> teeth) {
  std::vector<MeshTeeth> all;
  const auto at = [&](std::size_t end) { return teeth[static_cast<std::size_t>(problem.wheelOfEnd[end])]; };
  for (std::size_t end = 0; end < problem.wheelOfEnd.size(); end += 2)
    all.push_back({end / 2, at(end), at(end + 1)});
  return all;
}

Expected<PlacedMechanism> withTeethChosen(const PlacedMechanism& drawn, const TeethChoice& choice) {
  return withAllTeethFitted(drawn, choice.teeth);
}

}  // namespace geargraph
