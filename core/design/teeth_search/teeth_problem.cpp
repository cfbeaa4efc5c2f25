#include "core/design/teeth_search/teeth_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "core/design/teeth_search/wished_states.h"
#include "core/foundations/base/disjoint_sets.h"
#include "core/foundations/base/translation.h"
#include "core/machine/train/cut_limits.h"
#include "core/mechanism/kinds/pair_kind.h"
#include "core/mechanism/model/pins.h"
#include "core/mechanism/model/validate.h"
#include "core/theory/states/engagement.h"
#include "core/theory/states/relative_speed.h"
#include "core/theory/states/state_solution.h"

namespace geargraph {
namespace {

constexpr std::int64_t kNoHigh = std::numeric_limits<int>::max();

std::string endName(const Mechanism& mechanism, int end) {
  return std::to_string(mechanism.meshLabel(end / 2)) + (end % 2 == 0 ? ":tail" : ":head");
}

class ProblemMaker {
 public:
  ProblemMaker(const PlacedMechanism& drawn, const TeethWish& wish)
      : m_problem{drawn, wish, withWishedStates(drawn, wish), {}, {}, {}, {}, {}, {}},
        m_mechanism(drawn.mechanism()),
        m_placement(drawn.placement()) {}

  Expected<TeethProblem> run() {
    Diagnostics errors = treeDiagnostics(m_mechanism);
    append(errors, m_placement.diagnostics);
    std::erase_if(errors, [](const Diagnostic& each) { return each.severity() != Severity::error; });
    if (!errors.empty()) return errors;
    if (m_mechanism.gearMeshes.empty())
      return Diagnostic{
          Code::noMeshes, translated("There are no gears whose teeth could be chosen."), {}, {}, 0, 0};
    m_train = wheelsOf(m_mechanism, m_placement);
    m_sets = planetSets(m_mechanism, m_placement, PlanetScope::all);
    makeWheels();
    makeSums();
    for (const std::vector<PlanetGroup>& set : m_sets)
      m_problem.planets.emplace_back(set, m_placement, m_train, m_wheelOfGear);
    const auto model = KinematicModel::of(m_placement.tree->graph, m_placement.tree->tree, m_placement);
    for (std::size_t i = 0; i < m_problem.wish.ratios.size(); ++i) {
      if (auto wrong = addRatio(i, *model); !wrong.empty()) return wrong;
    }
    return std::move(m_problem);
  }

 private:
  [[nodiscard]] LinkOrdinal linkOf(int end) const {
    const MeshGeometry& geometry = *m_placement.meshes[end / 2];
    return end % 2 == 0 ? geometry.tail : geometry.head;
  }
  [[nodiscard]] int drawnTeeth(int end) const {
    const GearMesh& mesh = m_mechanism.gearMeshes[end / 2];
    return end % 2 == 0 ? mesh.tailTeeth : mesh.headTeeth;
  }
  [[nodiscard]] bool isRing(int end) const {
    return hasRing(m_placement.meshes[end / 2]->kind) && drawnTeeth(end) > drawnTeeth(end ^ 1);
  }

  /// Its teeth are the starts of a thread.
  [[nodiscard]] bool isWorm(int end) const {
    return pairKind(m_placement.meshes[end / 2]->kind).isThreaded && drawnTeeth(end) < drawnTeeth(end ^ 1);
  }

  [[nodiscard]] bool isCutByRack(int end) const {
    const PairKind& kind = pairKind(m_placement.meshes[end / 2]->kind);
    return kind.touches && kind.axes == LinePosition::parallel && !isRing(end);
  }

  /// Ends of one wheel of the train, and of corresponding wheels of equal planets.
  void makeWheels() {
    const std::size_t ends = 2 * m_mechanism.gearMeshes.size();
    DisjointSets joined(ends);
    std::vector<int> gearOfEnd(ends, -1);
    std::vector<int> firstOf(m_train.wheels.size(), -1);
    for (const TrainPair& pair : m_train.pairs) {
      for (const auto& [gear, end] :
           {std::pair(pair.tail, 2 * pair.mesh), std::pair(pair.head, 2 * pair.mesh + 1)}) {
        int& first = firstOf[static_cast<std::size_t>(int{gear})];
        if (first < 0) first = end;
        joined.join(first, end);
        gearOfEnd[static_cast<std::size_t>(end)] = gear;
      }
    }
    for (const std::vector<PlanetGroup>& set : m_sets) {
      for (const PlanetGroup& group : set) joinPlanets(set.front(), group, joined);
    }
    std::map<int, int> wheelOfRoot;
    std::vector<std::set<int>> gears;
    m_problem.wheelOfEnd.resize(ends);
    m_wheelOfGear.assign(m_train.wheels.size(), -1);
    for (int end = 0; end < static_cast<int>(ends); ++end) {
      const auto [found, isNew] =
          wheelOfRoot.try_emplace(joined.root(end), static_cast<int>(m_problem.wheels.size()));
      if (isNew) {
        m_problem.wheels.emplace_back();
        m_problem.wheels.back().name = endName(m_mechanism, end);
        m_problem.wheels.back().drawn = drawnTeeth(end);
        gears.emplace_back();
      }
      const int wheel = found->second;
      SearchedWheel& of = m_problem.wheels[static_cast<std::size_t>(wheel)];
      of.ends.push_back(end);
      of.isRing = of.isRing || isRing(end);
      of.isKept = of.isKept || isPinned(m_mechanism.links[linkOf(end)]) ||
                  isKept(endName(m_mechanism, end)) || isWorm(end);
      m_problem.wheelOfEnd[static_cast<std::size_t>(end)] = wheel;
      const int gear = gearOfEnd[static_cast<std::size_t>(end)];
      gears[static_cast<std::size_t>(wheel)].insert(gear);
      if (gear >= 0) m_wheelOfGear[static_cast<std::size_t>(gear)] = wheel;
      if (gear >= 0 && isCutByRack(end))
        of.fewestUncut = std::max(
            of.fewestUncut, fewestTeethUncut(m_mechanism, m_train.wheels[static_cast<std::size_t>(gear)]));
    }
    for (std::size_t wheel = 0; wheel < m_problem.wheels.size(); ++wheel) {
      m_problem.wheels[wheel].copies = static_cast<int>(gears[wheel].size());
      setCounts(m_problem.wheels[wheel]);
    }
  }

  void joinPlanets(const PlanetGroup& first, const PlanetGroup& group, DisjointSets& joined) const {
    for (std::size_t k = 0; k < first.meshes.size(); ++k) {
      const int one = 2 * first.meshes[k];
      const int other = 2 * group.meshes[k];
      for (std::size_t l = 0; l < first.links.size(); ++l) {
        for (const int end : {one, one + 1}) {
          if (linkOf(end) != first.links[l]) continue;
          const int same = linkOf(other) == group.links[l] ? other : other + 1;
          joined.join(end, same);
          joined.join(end ^ 1, same ^ 1);
        }
      }
    }
  }

  [[nodiscard]] bool isKept(const std::string& name) const {
    const std::vector<std::string>& kept = m_problem.wish.kept;
    return std::find(kept.begin(), kept.end(), name) != kept.end();
  }

  void setCounts(SearchedWheel& wheel) const {
    const TeethWish& wish = m_problem.wish;
    if (wheel.isKept) {
      wheel.counts = {wheel.drawn};
      return;
    }
    const int most = wheel.isRing ? wish.mostRing : wish.most;
    if (wish.stock.empty()) {
      for (int teeth = wish.fewest; teeth <= most; ++teeth) wheel.counts.push_back(teeth);
      return;
    }
    for (const int teeth : wish.stock)
      if (teeth >= wish.fewest && teeth <= most && (wheel.counts.empty() || wheel.counts.back() != teeth))
        wheel.counts.push_back(teeth);
  }

  /// N_tail + N_head, or N_ring - N_pinion, as factors by wheel.
  using Sum = std::map<int, int>;
  [[nodiscard]] Sum sumOf(MeshOrdinal mesh) const {
    const MeshKind kind = m_placement.meshes[mesh]->kind;
    Sum sum;
    for (const int end : {2 * mesh, 2 * mesh + 1})
      sum[m_problem.wheelOfEnd[static_cast<std::size_t>(end)]] += hasRing(kind) && !isRing(end) ? -1 : 1;
    return sum;
  }
  [[nodiscard]] std::int64_t drawnValue(const Sum& sum) const {
    std::int64_t value = 0;
    for (const auto& [wheel, factor] : sum)
      value += std::int64_t{factor} * m_problem.wheels[static_cast<std::size_t>(wheel)].drawn;
    return value;
  }
  void addSum(const Sum& sum, std::int64_t low, std::int64_t high) {
    SumCondition condition{{}, low, high};
    for (const auto& [wheel, factor] : sum)
      if (factor != 0) condition.terms.push_back({wheel, factor});
    if (!condition.terms.empty()) m_problem.sums.push_back(std::move(condition));
  }
  static Sum combined(const Sum& one, int factor, const Sum& other, int otherFactor) {
    Sum result;
    for (const auto& [wheel, each] : one) result[wheel] += factor * each;
    for (const auto& [wheel, each] : other) result[wheel] += otherFactor * each;
    return result;
  }

  /// The centre distance between two axes, with one module or with one of a train of wheels each.
  struct Distance {
    std::vector<Sum> sums;  ///< different ones
    bool isPinned = false;  ///< both axes are
    bool hasPinnedModule = false;
    int train = 0;  ///< wheels that share a module
  };

  void makeSums() {
    DisjointSets trains(m_problem.wheels.size());
    for (MeshOrdinal mesh = 0; mesh < m_mechanism.c(); ++mesh)
      trains.join(m_problem.wheelOfEnd[static_cast<std::size_t>(2 * mesh)],
                  m_problem.wheelOfEnd[static_cast<std::size_t>(2 * mesh + 1)]);
    const bool hasOneModule = m_problem.wish.hasOneModule;
    std::map<std::array<int, 3>, Distance> distances;
    for (MeshOrdinal mesh = 0; mesh < m_mechanism.c(); ++mesh) {
      const MeshGeometry& geometry = *m_placement.meshes[mesh];
      if (!hasParallelAxes(geometry.kind)) continue;
      const auto [low, high] = std::minmax({int{geometry.tailClass}, int{geometry.headClass}});
      const int train =
          hasOneModule ? 0 : trains.root(m_problem.wheelOfEnd[static_cast<std::size_t>(2 * mesh)]);
      Distance& distance = distances[{low, high, train}];
      const Sum sum = sumOf(mesh);
      if (std::find(distance.sums.begin(), distance.sums.end(), sum) == distance.sums.end())
        distance.sums.push_back(sum);
      distance.isPinned = isPinnedAxis(low) && isPinnedAxis(high);
      distance.hasPinnedModule = distance.hasPinnedModule || isPinned(m_mechanism.gearMeshes[mesh]);
      distance.train = train;
    }
    const int slack = m_problem.wish.slack;
    std::map<int, const Distance*> pinned;  // by train
    for (const auto& [axes, distance] : distances) {
      for (std::size_t i = 0; i < distance.sums.size(); ++i) {
        if (hasMinus(distance.sums[i])) addSum(distance.sums[i], 1, kNoHigh);  // the ring has more teeth
        for (std::size_t k = 0; k < (slack > 0 ? i : std::min<std::size_t>(i, 1)); ++k)
          addSum(combined(distance.sums[i], 1, distance.sums[k], -1), -slack, slack);
        if (m_problem.wish.keepsDistances || (distance.isPinned && distance.hasPinnedModule)) {
          const std::int64_t kept = drawnValue(distance.sums.front());
          addSum(distance.sums[i], kept - slack, kept + slack);
        }
      }
      if (!distance.isPinned) continue;
      const auto [first, isFirst] = pinned.try_emplace(distance.train, &distance);
      if (isFirst) continue;
      const Sum& one = first->second->sums.front();
      const Sum& other = distance.sums.front();
      addSum(combined(one, static_cast<int>(drawnValue(other)), other, -static_cast<int>(drawnValue(one))), 0,
             0);
    }
  }
  static bool hasMinus(const Sum& sum) {
    return std::any_of(sum.begin(), sum.end(), [](const auto& each) { return each.second < 0; });
  }
  [[nodiscard]] bool isPinnedAxis(AxisGroupOrdinal axisGroup) const {
    return isPinned(m_mechanism.axes[m_placement.classes->classes[axisGroup].axis]);
  }

  /// Planets that only copy others: their links are taken out of the equations.
  [[nodiscard]] std::set<int> copiesIn(const ShiftState& state) const {
    std::set<LinkId> named{*state.drive, *state.driven};
    for (const ShiftElementId id : state.engaged) {
      const ShiftElement* const coupling = m_problem.train.find(id);
      named.insert(coupling->links.begin(), coupling->links.end());
    }
    std::set<int> copies;
    for (const std::vector<PlanetGroup>& set : m_sets) {
      const bool isNamed = std::any_of(set.begin() + 1, set.end(), [&](const PlanetGroup& group) {
        return std::any_of(group.links.begin(), group.links.end(),
                           [&](LinkOrdinal link) { return named.contains(m_mechanism.links[link].id); });
      });
      if (isNamed) continue;
      for (std::size_t k = 1; k < set.size(); ++k) copies.insert(set[k].links.begin(), set[k].links.end());
    }
    return copies;
  }

  [[nodiscard]] SpeedRow meshRow(const KinematicModel& model, MeshOrdinal mesh) const {
    const KinematicModel::MeshRow& row = model.meshRow(mesh);
    SpeedRow result;
    const auto add = [&](int link, int factor, bool ofTail) {
      if (link != 0) result.entries.push_back({link - 1, factor, ofTail});
    };
    add(row.links[0], 1, true);
    add(row.links[1], -1, true);
    add(row.links[2], -row.sign, false);
    add(row.links[3], row.sign, false);
    result.tailWheel = m_problem.wheelOfEnd[static_cast<std::size_t>(2 * mesh)];
    result.headWheel = m_problem.wheelOfEnd[static_cast<std::size_t>(2 * mesh + 1)];
    return result;
  }

  static SpeedRow rowOf(const RelativeSpeed::Part& part) {
    SpeedRow row;
    for (const RelativeSpeed::Term& term : part.terms) row.entries.push_back({term.link - 1, term.factor});
    return row;
  }

  [[nodiscard]] std::vector<int> drawn() const {
    std::vector<int> teeth;
    for (const SearchedWheel& wheel : m_problem.wheels) teeth.push_back(wheel.drawn);
    return teeth;
  }

  [[nodiscard]] Diagnostics undetermined(const StateSolution& solution, const RatioWish& wish) const {
    Diagnostics found = solution.diagnostics;
    std::erase_if(found, [](const Diagnostic& each) { return each.code == Code::stateIdle; });
    if (!found.empty()) {
      // What warns of a state leaves a wish without an answer.
      for (Diagnostic& each : found) each.code = Code::schema;
      for (Diagnostic& each : found) each.detail = Detail::none;
      return found;
    }
    return {Diagnostic{Code::schema,
                       translated("The speeds of links %1 and %2 have no ratio that the teeth determine.",
                                  {std::to_string(m_mechanism.linkLabel(wish.drive)),
                                   std::to_string(m_mechanism.linkLabel(wish.driven))}),
                       {m_mechanism.links[wish.drive].id, m_mechanism.links[wish.driven].id},
                       {},
                       0,
                       0}};
  }

  /// Diagnostics of why there is no such ratio; empty if it was added.
  Diagnostics addRatio(std::size_t position, const KinematicModel& model) {
    const RatioWish& wish = m_problem.wish.ratios[position];
    const ShiftState& state = m_problem.train.states[position];
    const auto solution = solveState(m_problem.train, model, m_placement, static_cast<int>(position), false);
    if (hasErrors(solution->diagnostics)) return solution->diagnostics;
    if (!solution->driveTurns || solution->rates.empty()) return undetermined(*solution, wish);

    const std::set<int> copies = copiesIn(state);
    const int n = model.n();
    const std::vector<int> teeth = drawn();
    std::vector<SpeedRow> rows;
    std::vector<SpeedRow> left;
    int rank = 0;
    const auto addIfIndependent = [&](const SpeedRow& row) {
      rows.push_back(row);
      const int now = rankAt(rows, n, teeth);
      if (now == rank) rows.pop_back();
      const bool isNew = now > rank;
      rank = now;
      return isNew;
    };
    for (const int link : copies) addIfIndependent({{{link - 1, 1}}, -1, -1});
    for (const KinematicModel::HeldRow& held :
         engagementOf(m_problem.train, m_placement, solution->engaged).rows) {
      SpeedRow row;
      for (const auto& term : held.links) row.entries.push_back({term.of - 1, term.factor});
      addIfIndependent(row);
    }
    for (MeshOrdinal mesh = 0; mesh < m_mechanism.c(); ++mesh) {
      const MeshGeometry& geometry = *m_placement.meshes[mesh];
      if (copies.contains(geometry.tail) || copies.contains(geometry.head)) continue;
      const SpeedRow row = meshRow(model, mesh);
      if (!addIfIndependent(row)) left.push_back(row);
    }
    const SpeedRow drive = speedRow(wish.drive, {});
    const SpeedRow driven = speedRow(wish.driven, solution->rates);
    if (drive.entries.empty() || driven.entries.empty()) return undetermined(*solution, wish);
    // What idles beside drive and driven link is held, which changes nothing of the ratio.
    std::vector<SpeedRow> all = rows;
    all.push_back(drive);
    rank = rankAt(all, n, teeth);
    for (int column = 0; column < n && rank < n; ++column) {
      all.push_back({{{column, 1}}, -1, -1});
      const int now = rankAt(all, n, teeth);
      if (now > rank) rows.push_back(all.back());
      if (now == rank) all.pop_back();
      rank = now;
    }
    const auto varied = static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [](const SpeedRow& row) { return row.isOfMesh(); }));
    if (rank != n || varied + 1 > kMaxVariedMeshes)
      return {Diagnostic{
          Code::schema,
          translated("The ratio depends on %1 gear pairs: teeth are looked for in trains of at most %2.",
                     {std::to_string(varied), std::to_string(kMaxVariedMeshes - 1)}),
          {},
          "/ratios/" + std::to_string(position),
          0,
          0}};
    const auto bordered = [&](const SpeedRow& last) {
      std::vector<SpeedRow> square = rows;
      square.push_back(last);
      return determinantOf(square);
    };
    SearchedRatio ratio{bordered(drive), bordered(driven), wish.bounds};
    for (const SpeedRow& row : left) {
      TeethPolynomial closure = bordered(row);
      if (!closure.isZero()) m_problem.closures.push_back(std::move(closure));
    }
    dropCommonWheels(ratio.numerator, ratio.denominator);
    m_problem.ratios.push_back(std::move(ratio));
    return orient(position) ? Diagnostics{} : undetermined(*solution, wish);
  }

  /// The absolute speed of a link about the direction in which it turns; empty if it turns about several.
  [[nodiscard]] SpeedRow speedRow(LinkOrdinal link, const ByJoint<Rational>& rates) const {
    const RelativeSpeed speed = RelativeSpeed::between(m_placement, 0, link);
    if (rates.empty()) {
      for (const RelativeSpeed::Part& part : speed.parts)
        if (directionSign(m_placement, part.axisGroup, m_placement.classes->classOfLink(link)) != 0)
          return rowOf(part);
      return {};
    }
    const std::vector<SpeedAbout> turning = absoluteSpeed(m_placement, rates, link);
    for (const RelativeSpeed::Part& part : speed.parts) {
      const bool isOnly = speed.parts.size() == 1;
      if (isOnly ||
          (turning.size() == 1 && directionSign(m_placement, part.axisGroup, turning.front().axisGroup) != 0))
        return rowOf(part);
    }
    return {};
  }

  /// Gives the quotient the sign of the states' ratio, whose directions are those of the axes; false if the
  /// two differ, or none of the teeth that are tried gives a ratio.
  bool orient(std::size_t position) {
    SearchedRatio& ratio = m_problem.ratios[position];
    std::optional<int> sign;
    std::vector<int> teeth = drawn();
    std::uint64_t random = 0x9e3779b97f4a7c15U;
    for (int trial = 0; trial < 12; ++trial) {
      const auto numerator = ratio.numerator.at<Rational>(teeth);
      const auto denominator = ratio.denominator.at<Rational>(teeth);
      const auto solved = solvedRatio(m_problem, position, teeth);
      if (solved && !numerator.isZero() && !denominator.isZero()) {
        const Rational quotient = numerator / denominator;
        if (quotient.abs() != solved->abs()) return false;
        const int here = quotient == *solved ? 1 : -1;
        if (sign && *sign != here) return false;
        sign = here;
      }
      for (std::size_t wheel = 0; wheel < teeth.size(); ++wheel) {
        if (m_problem.wheels[wheel].isKept) continue;
        random = random * 6364136223846793005U + 1442695040888963407U;
        teeth[wheel] = 20 + static_cast<int>(random >> 40U) % 1000;
      }
    }
    if (!sign) return false;
    if (*sign < 0)
      for (TeethPolynomial::Term& term : ratio.numerator.terms) term.factor = -term.factor;
    return true;
  }

  TeethProblem m_problem;
  const Mechanism& m_mechanism;
  const Placement& m_placement;
  TrainWheels m_train;
  std::vector<std::vector<PlanetGroup>> m_sets;
  std::vector<int> m_wheelOfGear;
};

}  // namespace

bool TeethProblem::hasPlanets() const {
  return std::any_of(planets.begin(), planets.end(),
                     [&](const PlanetCondition& set) { return planetsOf(set) > 1 || set.hasTriangle(); });
}

Expected<TeethProblem> teethProblemOf(const PlacedMechanism& drawn, const TeethWish& wish) {
  return ProblemMaker(drawn, wish).run();
}

std::optional<Rational> solvedRatio(const TeethProblem& problem, std::size_t ratio,
                                    std::span<const int> teeth) {
  // Speeds depend on teeth and signs alone, wherever the axes would have to go.
  Placement placement = problem.drawn.placement();
  for (MeshOrdinal mesh = 0; mesh < placement.meshes.count(); ++mesh) {
    const auto at = [&](int end) {
      return teeth[static_cast<std::size_t>(problem.wheelOfEnd[static_cast<std::size_t>(end)])];
    };
    placement.meshes[mesh]->tailTeeth = at(2 * mesh);
    placement.meshes[mesh]->headTeeth = at(2 * mesh + 1);
    placement.meshes[mesh]->weights = {at(2 * mesh), at(2 * mesh + 1)};
  }
  const auto model = KinematicModel::of(placement.tree->graph, placement.tree->tree, placement);
  return solveState(problem.train, *model, placement, static_cast<int>(ratio), false)->ratio;
}

bool SearchedWheel::isUndercutWith(int teeth) const {
  constexpr double kEqual = 1e-9;  // a limit that is whole does not undercut
  return teeth < fewestUncut - kEqual;
}

}  // namespace geargraph
