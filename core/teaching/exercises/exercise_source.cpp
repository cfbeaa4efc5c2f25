#include "core/teaching/exercises/exercise_source.h"

#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/theory/matroid/coefficient_matrix.h"

namespace geargraph {
namespace {

/// All sets of couplings of at most `most`, small ones first; at most kMaxEngagedSets, but always the given
/// ones.
std::vector<std::vector<int>> setsOf(int couplings, std::size_t most,
                                     const std::vector<std::vector<int>>& given) {
  std::vector<std::vector<int>> sets = given;
  std::vector<std::vector<int>> last{{}};
  for (std::size_t size = 0; size <= most && !last.empty(); ++size) {
    std::vector<std::vector<int>> larger;
    for (const std::vector<int>& set : last) {
      if (sets.size() >= ExerciseSource::kMaxEngagedSets) return sets;
      if (std::find(sets.begin(), sets.end(), set) == sets.end()) sets.push_back(set);
      for (int next = set.empty() ? 0 : set.back() + 1; next < couplings; ++next) {
        larger.push_back(set);
        larger.back().push_back(next);
      }
    }
    last = std::move(larger);
  }
  return sets;
}

std::vector<int> positionsOf(const Mechanism& mechanism, const std::vector<ShiftElementId>& ids) {
  std::vector<int> positions;
  for (std::size_t i = 0; i < mechanism.couplings.size(); ++i) {
    if (std::find(ids.begin(), ids.end(), mechanism.couplings[i].id) != ids.end())
      positions.push_back(static_cast<int>(i));
  }
  return positions;
}

}  // namespace

ExerciseSource::ExerciseSource(const Mechanism& mechanism) {
  GEARGRAPH_REQUIRE(mechanism.n() <= kMaxExerciseLinks);
  Mechanism released = mechanism;
  released.engaged.clear();
  m_snapshot = analyzeLive(std::make_shared<const Mechanism>(std::move(released)));
  if (matroid() == nullptr) return;
  solveRates();
  solveStates();
}

void ExerciseSource::solveRates() {
  const std::vector<Rational> speeds(inputs().size(), 1);
  const auto exact = solveExact(*m_snapshot->kinematics->model, inputs(), speeds);
  GEARGRAPH_REQUIRE(exact.has_value());
  const std::size_t width = inputs().size();
  m_rates.assign(static_cast<std::size_t>(graph().t()), std::vector<Rational>(width));
  for (std::size_t i = 0; i < width; ++i) m_rates[static_cast<std::size_t>(inputs()[i])][i] = 1;
  for (std::size_t row = 0; row < exact->outputs.size(); ++row) {
    for (std::size_t i = 0; i < width; ++i)
      m_rates[static_cast<std::size_t>(exact->outputs[row])][i] = exact->matrix[row * width + i];
  }
}

void ExerciseSource::solveStates() {
  const Mechanism& document = mechanism();
  std::vector<std::vector<int>> given;
  std::size_t most = 0;
  for (const ShiftState& state : document.states) {
    given.push_back(positionsOf(document, state.engaged));
    most = std::max(most, given.back().size());
  }
  std::sort(given.begin(), given.end());
  given.erase(std::unique(given.begin(), given.end()), given.end());
  const auto sets = setsOf(static_cast<int>(document.couplings.size()), most + 1, given);
  for (std::size_t state = 0; state < document.states.size(); ++state) {
    const ShiftState& asked = document.states[state];
    const auto same = std::find_if(
        document.states.begin(), document.states.end(),
        [&](const ShiftState& other) { return other.drive == asked.drive && other.driven == asked.driven; });
    const auto first = static_cast<std::size_t>(same - document.states.begin());
    if (first < state) {
      m_engagedSets.push_back(m_engagedSets[first]);
      continue;
    }
    Mechanism tried = document;
    tried.states.clear();
    for (const std::vector<int>& set : sets) {
      ShiftState candidate{"", {}, asked.drive, asked.driven, {}};
      for (const ShiftElementOrdinal coupling : set)
        candidate.engaged.push_back(document.couplings[coupling].id);
      tried.states.push_back(std::move(candidate));
    }
    const LiveKinematics& live = *m_snapshot->kinematics;
    auto solved = geargraph::solveStates(tried, *live.model, live.placement(), false);
    GEARGRAPH_REQUIRE(solved.has_value());
    std::vector<EngagedSet> engaged;
    for (std::size_t i = 0; i < sets.size(); ++i) engaged.push_back({sets[i], std::move((*solved)[i])});
    m_engagedSets.push_back(std::move(engaged));
  }
}

std::optional<std::size_t> ExerciseSource::setOfState(int state) const {
  const std::vector<int> wanted =
      positionsOf(mechanism(), mechanism().states[static_cast<std::size_t>(state)].engaged);
  const std::vector<EngagedSet>& sets = engagedSets(state);
  const auto found =
      std::find_if(sets.begin(), sets.end(), [&](const EngagedSet& set) { return set.couplings == wanted; });
  if (found == sets.end()) return std::nullopt;
  return static_cast<std::size_t>(found - sets.begin());
}

const TtGraph* ExerciseSource::ttGraph() const {
  if (!m_snapshot->kinematics || !m_snapshot->kinematics->ttGraph->isComplete()) return nullptr;
  return m_snapshot->kinematics->ttGraph.get();
}

MeshKind ExerciseSource::meshKind(MeshOrdinal mesh) const {
  return m_snapshot->kinematics->placement().meshes[mesh]->kind;
}

std::vector<Rational> ExerciseSource::teethRow(MeshOrdinal mesh, RowChange change) const {
  const LiveKinematics& live = *m_snapshot->kinematics;
  const CoefficientMatrix coefficients(mechanism(), *live.model, live.placement());
  const GearMesh& gears = mechanism().gearMeshes[mesh];
  ByJoint<Rational> row(static_cast<std::size_t>(graph().t()));
  for (const CoefficientMatrix::Entry& entry : coefficients.row(mesh)) {
    const bool tailTeeth = entry.tail != (change == RowChange::upsideDown);
    const int sign = !entry.tail && change == RowChange::signOfHead ? -entry.sign : entry.sign;
    row[entry.joint] = sign * (tailTeeth ? gears.tailTeeth : gears.headTeeth);
  }
  return row;
}

std::string difficultyTitle(Difficulty level) {
  return level == Difficulty::easy     ? translated("Easy")
         : level == Difficulty::medium ? translated("Medium")
                                       : translated("Hard");
}

DifficultyNote difficultyOf(const ExerciseSource& source) {
  const int cycles = source.graph().c();
  std::string text =
      cycles == 1 ? translated("one cycle") : translated("%1 cycles", {std::to_string(cycles)});
  int weight = cycles;
  if (const MatroidAnalysis* matroid = source.matroid()) {
    text += ", " + (matroid->dof == 1 ? translated("one input")
                                      : translated("%1 inputs", {std::to_string(matroid->dof)}));
    const int redundant = cycles - matroid->rank;
    if (redundant > 0) text += ", " + translated("%1 redundant", {std::to_string(redundant)});
    weight += matroid->dof + 2 * redundant;
  }
  if (!source.mechanism().states.empty()) {
    text += ", " + translated("%1 states", {std::to_string(source.mechanism().states.size())});
    weight += 4;
  }
  const Difficulty level = weight <= 4   ? Difficulty::easy
                           : weight <= 9 ? Difficulty::medium
                                         : Difficulty::hard;
  return {level, level == Difficulty::easy     ? translated("easy: %1", {text})
                 : level == Difficulty::medium ? translated("medium: %1", {text})
                                               : translated("hard: %1", {text})};
}

}  // namespace geargraph
