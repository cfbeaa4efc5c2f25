#include "core/design/gearboxes/hub_search.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace geargraph {
namespace {

constexpr int kMinHubPlanets = 2;
constexpr int kMaxHubPlanets = 8;
constexpr int kMaxHubSetTeeth = 200'000;  ///< tooth sets of one set that fit its own ratios

/// What a sun has to do: the gears that its set alone makes with it.
struct SunTask {
  int reduction = -1;
  int increase = -1;
};

/// How the gears are made.
struct HubStructure {
  std::vector<std::vector<SunTask>> sets;
  /// By gear: for each set the sun that is held, with its mode, or -1 passed through.
  struct Use {
    int sun = -1;
    bool isIncrease = false;
  };
  std::vector<std::vector<Use>> gears;

  [[nodiscard]] std::size_t sunCount() const {
    return std::accumulate(sets.begin(), sets.end(), std::size_t{0},
                           [](std::size_t sum, const auto& set) { return sum + set.size(); });
  }
};

/// An interval of ratios, ends exact; whether they count is asked when teeth are known.
struct RatioSpan {
  Rational low = 1;
  Rational high = 1;
};

RatioSpan spanOf(const WantedRatio& ratio) {
  return {ratio.lowest, ratio.highest};
}

bool meet(const RatioSpan& a, const RatioSpan& b) {
  return a.low <= b.high && b.low <= a.high;
}

RatioSpan times(const RatioSpan& a, const RatioSpan& b) {
  return {a.low * b.low, a.high * b.high};
}

/// Finds the structures with the fewest suns: each gear is passed through, a sun's own, or a product.
class Structures {
 public:
  explicit Structures(const HubWish& wish) : m_wish(wish) {
    m_current.sets.resize(static_cast<std::size_t>(wish.sets));
  }

  std::vector<HubStructure> all() {
    const std::size_t most = static_cast<std::size_t>(m_wish.sets) * mostSuns();
    for (m_suns = 1; m_suns <= most && m_found.empty(); ++m_suns) place(0, 0);
    return std::move(m_found);
  }

 private:
  [[nodiscard]] std::size_t mostSuns() const {
    return m_wish.isStepped ? static_cast<std::size_t>(kMaxHubSuns) : 1;
  }
  [[nodiscard]] bool isDirect(std::size_t gear) const { return m_wish.ratios[gear].admits(Rational(1)); }

  /// Decides the gear at a position: a sun's own in one of the sets, or left to be a product.
  void place(std::size_t gear, std::size_t usedSets) {
    if (m_current.sunCount() > m_suns) return;
    if (gear == m_wish.ratios.size()) {
      if (m_current.sunCount() == m_suns) complete(usedSets);
      return;
    }
    place(gear + 1, usedSets);  // passed through or a product, seen in complete()
    if (isDirect(gear)) return;
    const bool isIncrease = m_wish.ratios[gear].value > Rational(1);
    const std::size_t sets = std::min(usedSets + 1, m_current.sets.size());
    for (std::size_t set = 0; set < sets; ++set) {
      auto& suns = m_current.sets[set];
      for (SunTask& sun : suns) {  // the other mode of a sun that is there
        int& own = isIncrease ? sun.increase : sun.reduction;
        const int other = isIncrease ? sun.reduction : sun.increase;
        if (own >= 0 || !areInverse(static_cast<std::size_t>(other), gear)) continue;
        own = static_cast<int>(gear);
        place(gear + 1, std::max(usedSets, set + 1));
        own = -1;
      }
      if (suns.size() == mostSuns() || m_current.sunCount() == m_suns) continue;
      suns.push_back(isIncrease ? SunTask{-1, static_cast<int>(gear)} : SunTask{static_cast<int>(gear), -1});
      place(gear + 1, std::max(usedSets, set + 1));
      suns.pop_back();
    }
  }

  [[nodiscard]] bool areInverse(std::size_t a, std::size_t b) const {
    const RatioSpan product = times(spanOf(m_wish.ratios[a]), spanOf(m_wish.ratios[b]));
    return meet(product, {Rational(1), Rational(1)});
  }

  /// Every gear that is no sun's own has to be a product in exactly the ways that are tried here.
  void complete(std::size_t usedSets) {
    HubStructure structure = m_current;
    structure.sets.resize(usedSets);
    if (std::any_of(structure.sets.begin(), structure.sets.end(),
                    [](const auto& set) { return set.empty(); }))
      return;
    structure.gears.assign(m_wish.ratios.size(), std::vector<HubStructure::Use>(usedSets));
    std::vector<char> isOwn(m_wish.ratios.size(), 0);
    for (std::size_t set = 0; set < usedSets; ++set) {
      for (std::size_t sun = 0; sun < structure.sets[set].size(); ++sun) {
        const SunTask& task = structure.sets[set][sun];
        for (const bool isIncrease : {false, true}) {
          const int gear = isIncrease ? task.increase : task.reduction;
          if (gear < 0) continue;
          structure.gears[static_cast<std::size_t>(gear)][set] = {static_cast<int>(sun), isIncrease};
          isOwn[static_cast<std::size_t>(gear)] = 1;
        }
      }
    }
    explain(structure, isOwn, 0);
  }

  void explain(HubStructure& structure, const std::vector<char>& isOwn, std::size_t gear) {
    if (gear == isOwn.size()) {
      m_found.push_back(structure);
      return;
    }
    if (isOwn[gear] != 0) return explain(structure, isOwn, gear + 1);
    std::vector<HubStructure::Use> uses(structure.sets.size());
    const auto choose = [&](const auto& self, std::size_t set, const RatioSpan& product,
                            std::size_t held) -> void {
      if (set == structure.sets.size()) {
        if (held == 1 || !meet(product, spanOf(m_wish.ratios[gear]))) return;
        if (held == 0 && !isDirect(gear)) return;
        structure.gears[gear] = uses;
        explain(structure, isOwn, gear + 1);
        return;
      }
      uses[set] = {};
      self(self, set + 1, product, held);
      for (std::size_t sun = 0; sun < structure.sets[set].size(); ++sun) {
        const SunTask& task = structure.sets[set][sun];
        for (const bool isIncrease : {false, true}) {
          const int own = isIncrease ? task.increase : task.reduction;
          if (own < 0) continue;
          uses[set] = {static_cast<int>(sun), isIncrease};
          self(self, set + 1, times(product, spanOf(m_wish.ratios[static_cast<std::size_t>(own)])), held + 1);
        }
      }
      uses[set] = {};
    };
    choose(choose, 0, {}, 0);
    structure.gears[gear].assign(structure.sets.size(), {});
  }

  const HubWish& m_wish;
  std::size_t m_suns = 1;
  HubStructure m_current;
  std::vector<HubStructure> m_found;
};

/// Can n equal planets with these steps be assembled with the ring and every sun? A planet that is n-th of a
/// turn further on has turned by d against its carrier, p_r d = R/n + t for a whole t; each sun on a step p
/// needs p d + S/n whole.
bool planetsAssemble(const HubSet& set, int planets) {
  const int ringStep = set.suns.front().planet;
  for (int shift = 0; shift < ringStep; ++shift) {
    const Rational turn = (Rational(set.ring, planets) + Rational(shift)) / Rational(ringStep);
    const bool isRight = std::all_of(set.suns.begin(), set.suns.end(), [&](const HubSun& sun) {
      return (Rational(sun.planet) * turn + Rational(sun.teeth, planets)).isInteger();
    });
    if (isRight) return true;
  }
  return false;
}

bool hubPlanetsClear(const HubSet& set, int planets) {
  const double centre = set.suns.front().teeth + set.suns.front().planet;
  int largest = 0;
  for (const HubSun& sun : set.suns) largest = std::max(largest, sun.planet);
  return centre * std::sin(std::numbers::pi / planets) > largest + 2;
}

/// All teeth of one set of a structure that meet its own gears.
class SetTeethSearch {
 public:
  SetTeethSearch(const HubWish& wish, const std::vector<SunTask>& tasks, std::size_t position,
                 const std::stop_token& stop)
      : m_wish(wish), m_tasks(tasks), m_position(position), m_stop(stop) {}

  std::vector<HubSet> all() {
    for (std::size_t base = 0; base < m_tasks.size(); ++base) {
      m_order.clear();
      m_order.push_back(base);
      for (std::size_t other = 0; other < m_tasks.size(); ++other) {
        if (other != base) m_order.push_back(other);
      }
      for (int ring = m_wish.rings[0]; ring <= m_wish.rings[1]; ++ring) {
        if (m_stop.stop_requested()) return {};
        for (int planet = m_wish.planets[0]; planet <= m_wish.planets[1]; ++planet) searchRing(ring, planet);
      }
    }
    return std::move(m_found);
  }

 private:
  void searchRing(int ring, int ringStep) {
    m_set = {};
    m_set.ring = ring;
    addSun(0, ringStep, ring - ringStep, ring - ringStep);
  }

  /// `least`, `most`: the centre sums so far.
  void addSun(std::size_t place, int ringStep, int least, int most) {
    if (place == m_order.size()) return complete();
    const SunTask& task = m_tasks[m_order[place]];
    const int from = place == 0 ? ringStep : m_wish.planets[0];
    const int to = place == 0 ? ringStep : m_wish.planets[1];
    for (int planet = from; planet <= to; ++planet) {
      const bool isTaken = std::any_of(m_set.suns.begin(), m_set.suns.end(),
                                       [planet](const HubSun& sun) { return sun.planet == planet; });
      if (isTaken) continue;
      const int fewest = std::max(m_wish.suns[0], most - m_wish.slack - planet);
      const int mostTeeth = std::min(m_wish.suns[1], least + m_wish.slack - planet);
      for (int teeth = fewest; teeth <= mostTeeth; ++teeth) {
        m_set.suns.push_back({teeth, planet, task.reduction, task.increase});
        const Rational reduction = m_set.reduction(place);
        const bool isMet =
            (task.reduction < 0 ||
             m_wish.ratios[static_cast<std::size_t>(task.reduction)].admits(reduction)) &&
            (task.increase < 0 ||
             m_wish.ratios[static_cast<std::size_t>(task.increase)].admits(reduction.inverse()));
        if (isMet)
          addSun(place + 1, ringStep, std::min(least, teeth + planet), std::max(most, teeth + planet));
        m_set.suns.pop_back();
      }
    }
  }

  void complete() {
    if (m_found.size() >= kMaxHubSetTeeth) return;
    for (const auto& [name, teeth] : hubWheels({{m_set}, {}})) {
      const auto counted = m_wish.counted.find(std::to_string(m_position + 1) + name.substr(1));
      if (counted != m_wish.counted.end() && counted->second != teeth) return;
    }
    HubSet set = m_set;
    for (int planets = kMinHubPlanets; planets <= kMaxHubPlanets; ++planets) {
      if (planetsAssemble(set, planets) && hubPlanetsClear(set, planets)) set.planets.push_back(planets);
    }
    m_found.push_back(std::move(set));
  }

  const HubWish& m_wish;
  const std::vector<SunTask>& m_tasks;
  std::size_t m_position;
  std::stop_token m_stop;
  std::vector<std::size_t> m_order;
  HubSet m_set;
  std::vector<HubSet> m_found;
};

/// Whole teeth of a set with so many suns within the limits and the slack, the suns on different steps: those
/// whose centre sums are within a window less those of which the least sum is not its lower end.
std::int64_t toothSetsOf(const HubWish& wish, std::size_t suns) {
  const auto countIn = [&](int planet, int low, int high) -> std::int64_t {
    return std::max(0, std::min(wish.suns[1], high - planet) - std::max(wish.suns[0], low - planet) + 1);
  };
  const auto within = [&](int low, int high) {
    std::int64_t all = 0;
    for (int ringStep = wish.planets[0]; ringStep <= wish.planets[1]; ++ringStep) {
      const std::int64_t rings =
          std::max(0, std::min(wish.rings[1], high + ringStep) - std::max(wish.rings[0], low + ringStep) + 1);
      std::int64_t sum = 0;
      std::int64_t squares = 0;
      for (int planet = wish.planets[0]; planet <= wish.planets[1]; ++planet) {
        if (planet == ringStep) continue;
        const std::int64_t own = countIn(planet, low, high);
        sum += own;
        squares += own * own;
      }
      const std::int64_t others = suns == 1 ? 1 : suns == 2 ? sum : sum * sum - squares;
      all += rings * countIn(ringStep, low, high) * others;
    }
    return all;
  };
  std::int64_t all = 0;
  for (int low = wish.rings[0] - wish.planets[1] - wish.slack; low <= wish.rings[1]; ++low) {
    all += within(low, low + wish.slack);
    if (wish.slack > 0) all -= within(low + 1, low + wish.slack);
  }
  return all;
}

/// Combines the sets' teeth to candidates that meet all gears.
class Combination {
 public:
  Combination(const HubWish& wish, const HubStructure& structure,
              const std::vector<std::vector<HubSet>>& sets, const std::stop_token& stop)
      : m_wish(wish), m_structure(structure), m_sets(sets), m_stop(stop) {}

  void addTo(HubSearch& search) {
    m_search = &search;
    choose(0);
  }

 private:
  void choose(std::size_t set) {
    if (m_stop.stop_requested()) return;
    if (set == m_sets.size()) {
      (m_candidate.assembles() ? m_search->assembled : m_search->others).push_back(m_candidate);
      return;
    }
    for (const HubSet& each : m_sets[set]) {
      m_candidate.sets.push_back(each);
      if (meetsGears(set)) choose(set + 1);
      m_candidate.sets.pop_back();
    }
  }

  /// Are the gears met in which this set, but none after it, holds a sun?
  bool meetsGears(std::size_t last) {
    m_candidate.ratios.resize(m_wish.ratios.size());
    for (std::size_t gear = 0; gear < m_wish.ratios.size(); ++gear) {
      const auto& uses = m_structure.gears[gear];
      std::size_t deepest = 0;
      for (std::size_t set = 0; set < uses.size(); ++set) {
        if (uses[set].sun >= 0) deepest = set;
      }
      if (deepest != last) continue;
      Rational product = 1;
      for (std::size_t set = 0; set <= last; ++set) {
        if (uses[set].sun < 0) continue;
        const HubSet& own = m_candidate.sets[set];
        const int task = uses[set].isIncrease
                             ? m_structure.sets[set][static_cast<std::size_t>(uses[set].sun)].increase
                             : m_structure.sets[set][static_cast<std::size_t>(uses[set].sun)].reduction;
        for (std::size_t sun = 0; sun < own.suns.size(); ++sun) {
          if ((uses[set].isIncrease ? own.suns[sun].increase : own.suns[sun].reduction) != task) continue;
          product *= uses[set].isIncrease ? own.reduction(sun).inverse() : own.reduction(sun);
        }
      }
      if (!m_wish.ratios[gear].admits(product)) return false;
      for (const MeasuredRatio& measured : m_wish.measured) {
        if (measured.gear == static_cast<int>(gear) && !measured.ratio.admits(product)) return false;
      }
      m_candidate.ratios[gear] = product;
    }
    return true;
  }

  const HubWish& m_wish;
  const HubStructure& m_structure;
  const std::vector<std::vector<HubSet>>& m_sets;
  std::stop_token m_stop;
  HubSearch* m_search = nullptr;
  HubCandidate m_candidate;
};

int teethSum(const HubCandidate& candidate) {
  int sum = 0;
  for (const auto& [name, teeth] : hubWheels(candidate)) sum += teeth;
  return sum;
}

/// The least choice of numbers of planets among the sets.
std::size_t planetChoices(const HubCandidate& candidate) {
  std::size_t least = kMaxHubPlanets;
  for (const HubSet& set : candidate.sets) least = std::min(least, set.planets.size());
  return least;
}

/// Fewest sets, then the most numbers of planets that can be assembled, then the fewest teeth.
bool hubRanksBefore(const HubCandidate& a, const HubCandidate& b) {
  if (a.sets.size() != b.sets.size()) return a.sets.size() < b.sets.size();
  const std::size_t choicesA = planetChoices(a);
  const std::size_t choicesB = planetChoices(b);
  if (choicesA != choicesB) return choicesA > choicesB;
  const int sumA = teethSum(a);
  const int sumB = teethSum(b);
  if (sumA != sumB) return sumA < sumB;
  return hubWheels(a) < hubWheels(b);
}

/// Whole degrees of the output after kMeasuredTurns of the input.
std::string degreesOf(const Rational& ratio) {
  const double degrees = (ratio * Rational(360 * kMeasuredTurns)).toDouble();
  return std::to_string(static_cast<std::int64_t>(std::llround(degrees)));
}

std::string gearQuestion(std::size_t gear) {
  return "gear " + std::to_string(gear + 1);
}

void addQuestion(HubSearch& search, HubQuestion question) {
  std::map<std::string, std::size_t> counts;
  for (const std::string& answer : question.answers) ++counts[answer];
  if (counts.size() < 2) return;
  for (const auto& [answer, count] : counts) question.leaves = std::max(question.leaves, count);
  search.questions.push_back(std::move(question));
}

/// The answer that a candidate gives: the teeth of a wheel, empty where there is none, or degrees.
std::string answerOf(const HubCandidate& candidate, const HubQuestion& question) {
  if (!question.isCount) {
    for (std::size_t gear = 0; gear < candidate.ratios.size(); ++gear)
      if (question.name == gearQuestion(gear)) return degreesOf(candidate.ratios[gear]);
    return {};
  }
  for (const auto& [name, teeth] : hubWheels(candidate))
    if (name == question.name) return std::to_string(teeth);
  return {};
}

/// What to count or measure: every wheel, then every gear.
void findQuestions(HubSearch& search) {
  search.questions.clear();
  std::vector<std::string> names;
  for (const HubCandidate& each : search.assembled) {
    for (const auto& [name, teeth] : hubWheels(each)) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  std::vector<HubQuestion> questions;
  for (const std::string& name : names) questions.push_back({name, true, {}, 0});
  const std::size_t gears = search.assembled.empty() ? 0 : search.assembled.front().ratios.size();
  for (std::size_t gear = 0; gear < gears; ++gear) questions.push_back({gearQuestion(gear), false, {}, 0});
  for (HubQuestion& question : questions) {
    for (const HubCandidate& each : search.assembled) question.answers.push_back(answerOf(each, question));
    addQuestion(search, std::move(question));
  }
  std::stable_sort(search.questions.begin(), search.questions.end(),
                   [](const HubQuestion& a, const HubQuestion& b) { return a.leaves < b.leaves; });
}

}  // namespace

Rational HubSet::reduction(std::size_t sun) const {
  const Rational x(static_cast<std::int64_t>(suns[sun].teeth) * suns.front().planet,
                   static_cast<std::int64_t>(suns[sun].planet) * ring);
  return (Rational(1) + x).inverse();
}

bool HubCandidate::assembles() const {
  return std::all_of(sets.begin(), sets.end(), [](const HubSet& set) { return !set.planets.empty(); });
}

std::string hubWheelName(std::size_t set, std::string_view kind, std::size_t step) {
  std::string name = std::to_string(set + 1) + '.' + std::string(kind);
  return kind == "ring" ? name : name + std::to_string(step + 1);
}

std::vector<std::pair<std::string, int>> hubWheels(const HubCandidate& candidate) {
  std::vector<std::pair<std::string, int>> wheels;
  for (std::size_t set = 0; set < candidate.sets.size(); ++set) {
    for (std::size_t sun = 0; sun < candidate.sets[set].suns.size(); ++sun) {
      wheels.emplace_back(hubWheelName(set, "sun", sun), candidate.sets[set].suns[sun].teeth);
      wheels.emplace_back(hubWheelName(set, "planet", sun), candidate.sets[set].suns[sun].planet);
    }
    wheels.emplace_back(hubWheelName(set, "ring", 0), candidate.sets[set].ring);
  }
  return wheels;
}

HubSearch narrowed(HubSearch search, const HubQuestion& question, const std::string& answer) {
  const auto differs = [&](const HubCandidate& each) { return answerOf(each, question) != answer; };
  std::erase_if(search.assembled, differs);
  std::erase_if(search.others, differs);
  findQuestions(search);
  return search;
}

std::optional<HubSearch> findHubs(const HubWish& wish, const std::stop_token& stop) {
  HubSearch search;
  const std::vector<HubStructure> structures = Structures(wish).all();
  search.structures = static_cast<int>(structures.size());
  for (const HubStructure& structure : structures) {
    std::vector<std::vector<HubSet>> sets;
    for (std::size_t set = 0; set < structure.sets.size(); ++set) {
      sets.push_back(SetTeethSearch(wish, structure.sets[set], set, stop).all());
      if (&structure == &structures.front())
        search.tried.push_back(toothSetsOf(wish, structure.sets[set].size()));
    }
    Combination(wish, structure, sets, stop).addTo(search);
    if (stop.stop_requested()) return std::nullopt;
  }
  std::sort(search.assembled.begin(), search.assembled.end(), hubRanksBefore);
  std::sort(search.others.begin(), search.others.end(), hubRanksBefore);
  findQuestions(search);
  return search;
}

}  // namespace geargraph
