#include "core/design/gearboxes/gearbox.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/design/gearboxes/candidate_refinement.h"
#include "core/design/gearboxes/gear_balance.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxOptions = 24;    ///< tooth counts of a set that are combined
constexpr std::size_t kMaxChecked = 16;    ///< combinations that are computed in fractions
constexpr std::size_t kMaxVariants = 512;  ///< choices of elements that are compared

std::vector<Rational> ringRatios(const std::vector<TeethOption>& teeth) {
  std::vector<Rational> k;
  for (const TeethOption& option : teeth) {
    for (const SetTeeth& part : option.parts) k.push_back(part.k());
  }
  return k;
}

/// The wanted ratio of a gear; null for any reverse.
const WantedRatio* wantedOf(const GearboxWish& wish, std::size_t gear) {
  if (gear < wish.forward.size()) return &wish.forward[gear];
  return wish.reverseRatio ? &*wish.reverseRatio : nullptr;
}

std::string gearName(const GearboxWish& wish, std::size_t gear) {
  return gear < wish.forward.size() ? std::to_string(gear + 1) : "R";
}

/// Whole teeth for a candidate: combinations of the sets' tooth counts, by the error that the gradients at
/// the refined ring ratios foretell, the first few of them checked in fractions.
class LayoutTeeth {
 public:
  LayoutTeeth(const GearboxWish& wish, const GearboxCandidate& candidate)
      : m_wish(wish), m_candidate(candidate), m_sets(basicSets(wish.limits.kinds)) {
    for (const auto& gear : candidate.gears) {
      std::array<ElementLinks, 3> links{};
      for (std::size_t i = 0; i < gear.size(); ++i) links[i] = candidate.elements[gear[i]].variants.front();
      m_states.push_back(links);
    }
  }

  /// The best teeth with the exact states, whose elements are those of the candidate. False if none meets all
  /// ratios.
  bool choose(std::vector<TeethOption>& teeth, std::vector<GearState>& gears) {
    if (!findOptions() || !foretell()) return false;
    bool found = false;
    Rational least;
    for (const auto& [miss, places] : m_foretold) {
      std::vector<TeethOption> option;
      for (std::size_t i = 0; i < places.size(); ++i) option.push_back(m_options[i][places[i]]);
      auto states = exactStates(option);
      if (!states) continue;
      Rational worst;
      for (const GearState& each : *states) worst = std::max(worst, each.error);
      if (found && worst >= least) continue;
      found = true;
      least = worst;
      teeth = std::move(option);
      gears = *std::move(states);
    }
    return found;
  }

 private:
  using Places = std::vector<std::size_t>;

  bool findOptions() {
    double tolerance = 0;
    for (std::size_t gear = 0; gear < m_candidate.gears.size(); ++gear) {
      if (const WantedRatio* wanted = wantedOf(m_wish, gear))
        tolerance = std::max(tolerance, (wanted->highest / wanted->value).toDouble() - 1);
    }
    const double window = std::clamp(3 * tolerance, 0.01, 0.04);
    std::size_t set = 0;
    for (const SetKind kind : m_wish.limits.kinds) {
      const std::size_t parts = kind == SetKind::ravigneaux ? 2 : 1;
      m_options.push_back(
          teethNear(kind, std::span(m_candidate.k).subspan(set, parts), m_wish.teeth, window, kMaxOptions));
      if (m_options.back().empty()) return false;
      set += parts;
    }
    return true;
  }

  /// Sorts all combinations by the foretold error over the tolerance, and keeps the first.
  bool foretell() {
    constexpr double kDifference = 1e-6;
    const StateRatios ratios(m_sets, m_candidate.layout, m_wish.limits.shafts);
    const std::size_t count = m_states.size();
    std::vector<double> values(count);
    if (!ratios.at(m_candidate.k, m_states, values)) return false;
    std::vector<std::array<double, kMaxSets>> gradients(count);
    for (std::size_t set = 0; set < m_sets.size(); ++set) {
      std::vector<double> k = m_candidate.k;
      k[set] *= 1 + kDifference;
      std::vector<double> moved(count);
      if (!ratios.at(k, m_states, moved)) return false;
      for (std::size_t gear = 0; gear < count; ++gear)
        gradients[gear][set] = std::log(std::abs(moved[gear] / values[gear])) / kDifference;
    }
    std::vector<std::size_t> wanted;
    std::vector<double> residuals;
    std::vector<double> tolerances;
    for (std::size_t gear = 0; gear < count; ++gear) {
      const WantedRatio* each = wantedOf(m_wish, gear);
      if (each == nullptr) continue;
      wanted.push_back(gear);
      residuals.push_back(std::log(each->value.toDouble() / std::abs(values[gear])));
      tolerances.push_back(std::max(1e-7, (each->highest / each->value).toDouble() - 1));
    }
    Places places(m_options.size(), 0);
    for (bool more = true; more;) {
      std::array<double, kMaxSets> moves{};
      std::size_t set = 0;
      for (std::size_t i = 0; i < places.size(); ++i) {
        for (const SetTeeth& part : m_options[i][places[i]].parts) {
          moves[set] = std::log(part.ring / (part.sun * m_candidate.k[set]));
          ++set;
        }
      }
      double miss = 0;
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        double left = residuals[i];
        for (std::size_t j = 0; j < set; ++j) left -= gradients[wanted[i]][j] * moves[j];
        miss = std::max(miss, std::abs(left) / tolerances[i]);
      }
      keep(miss, places);
      more = false;
      for (std::size_t i = 0; i < places.size() && !more; ++i) {
        more = ++places[i] < m_options[i].size();
        if (!more) places[i] = 0;
      }
    }
    return !m_foretold.empty();
  }

  void keep(double miss, const Places& places) {
    constexpr double kFar = 3;  // beyond what the second order of the moves can mend
    if (miss > kFar) return;
    if (m_foretold.size() == kMaxChecked && miss >= m_foretold.back().first) return;
    const std::pair<double, Places> entry(miss, places);
    m_foretold.insert(std::upper_bound(m_foretold.begin(), m_foretold.end(), entry), entry);
    if (m_foretold.size() > kMaxChecked) m_foretold.pop_back();
  }

  [[nodiscard]] std::optional<std::vector<GearState>> exactStates(
      const std::vector<TeethOption>& teeth) const {
    const std::vector<Rational> k = ringRatios(teeth);
    const FractionNumbers numbers;
    const auto space =
        speedSpace<FractionNumbers>(m_sets, m_candidate.layout, m_wish.limits.shafts, k, numbers);
    if (!space) return std::nullopt;
    std::vector<GearState> states;
    for (std::size_t gear = 0; gear < m_states.size(); ++gear) {
      std::array<std::array<Rational, kMaxFreedom>, 3> engaged{};
      for (std::size_t i = 0; i < m_candidate.gears[gear].size(); ++i)
        engaged[i] = directionOf(*space, m_states[gear][i], numbers);
      const Rational in = speedWith(engaged, space->rows[m_candidate.layout.input], space->freedom, numbers);
      const Rational out =
          speedWith(engaged, space->rows[m_candidate.layout.output], space->freedom, numbers);
      if (in.isZero() || out.isZero()) return std::nullopt;
      GearState state;
      state.name = gearName(m_wish, gear);
      state.ratio = in / out;
      const bool isReverse = gear >= m_wish.forward.size();
      if ((state.ratio.sign() < 0) != isReverse) return std::nullopt;
      if (const WantedRatio* wanted = wantedOf(m_wish, gear)) {
        const Rational size = state.ratio.abs();
        if (!wanted->admits(size)) return std::nullopt;
        state.error = wanted->errorOf(size);
      }
      for (const std::uint8_t each : m_candidate.gears[gear]) state.engaged.push_back(each);
      states.push_back(std::move(state));
    }
    return states;
  }

  const GearboxWish& m_wish;
  const GearboxCandidate& m_candidate;
  BasicSets m_sets;
  std::vector<std::array<ElementLinks, 3>> m_states;
  std::vector<std::vector<TeethOption>> m_options;
  std::vector<std::pair<double, Places>> m_foretold;
};

bool isLinkTouched(const std::vector<ElementLinks>& elements, int link) {
  return std::any_of(elements.begin(), elements.end(),
                     [link](const ElementLinks& each) { return each.a == link || each.b == link; });
}

/// Does an element end at every link that only one member is on, or none, and that is neither input with a
/// member nor output?
bool usesAllLinks(const BasicSets& sets, const GearLayout& layout, int shafts,
                  const std::vector<ElementLinks>& elements) {
  for (int link = 1; link <= shafts; ++link) {
    int members = 0;
    for (std::size_t set = 0; set < sets.size(); ++set) {
      for (std::size_t member = 0; member < (sets[set].sharesRing ? 1U : 3U); ++member)
        members += layout.linkOf[3 * set + member] == link ? 1 : 0;
    }
    const bool isOpen = link == layout.input ? members == 0 : members == 1 && link != layout.output;
    if (isOpen && !isLinkTouched(elements, link)) return false;
  }
  return true;
}

/// The largest torque and slip of a choice of elements, in doubles.
struct Demand {
  bool isDrawable = false;
  double torque = 0;
  double slip = 0;

  [[nodiscard]] bool isLess(const Demand& other) const {
    constexpr double kEqual = 1e-9;
    if (isDrawable != other.isDrawable) return isDrawable;
    if (std::abs(torque - other.torque) > kEqual) return torque < other.torque;
    return slip < other.slip - kEqual;
  }
};

std::vector<ElementLinks> engagedOf(const std::vector<ElementLinks>& elements, const GearState& gear) {
  std::vector<ElementLinks> engaged;
  for (const int each : gear.engaged) engaged.push_back(elements[static_cast<std::size_t>(each)]);
  return engaged;
}

Demand demandOf(const BasicSets& sets, int shafts, const Gearbox& gearbox, std::span<const double> k) {
  const DoubleNumbers numbers;
  Demand demand;
  demand.isDrawable = !brokenSectionRule(sets, gearbox.layout, shafts, gearbox.elements);
  for (const GearState& gear : gearbox.gears) {
    const auto balance = gearBalance<DoubleNumbers>(sets, gearbox.layout, shafts, k,
                                                    engagedOf(gearbox.elements, gear), numbers);
    if (!balance) continue;
    for (const double each : balance->elements) demand.torque = std::max(demand.torque, std::abs(each));
    for (const ElementLinks& each : gearbox.elements)
      demand.slip = std::max(demand.slip, std::abs(balance->speeds[each.a] - balance->speeds[each.b]));
  }
  return demand;
}

/// Chooses for each element the variant that asks least. False if none has as many brakes and clutches as
/// wished, or a link of one member is left without an element.
bool chooseVariants(const GearboxWish& wish, const BasicSets& sets, const std::vector<ElementClass>& classes,
                    Gearbox& gearbox) {
  std::vector<double> k;
  for (const Rational& each : ringRatios(gearbox.teeth)) k.push_back(each.toDouble());
  std::vector<std::size_t> at(classes.size(), 0);
  std::optional<Demand> least;
  std::vector<ElementLinks> best;
  std::size_t tried = 0;
  for (bool more = true; more && tried < kMaxVariants; ++tried) {
    gearbox.elements.clear();
    for (std::size_t i = 0; i < classes.size(); ++i) gearbox.elements.push_back(classes[i].variants[at[i]]);
    const auto brakes =
        static_cast<int>(std::count_if(gearbox.elements.begin(), gearbox.elements.end(),
                                       [](const ElementLinks& each) { return each.isBrake(); }));
    const int clutches = static_cast<int>(classes.size()) - brakes;
    const bool isCount = brakes >= wish.brakes[0] && brakes <= wish.brakes[1] &&
                         clutches >= wish.clutches[0] && clutches <= wish.clutches[1];
    if (isCount && usesAllLinks(sets, gearbox.layout, wish.limits.shafts, gearbox.elements)) {
      const Demand demand = demandOf(sets, wish.limits.shafts, gearbox, k);
      if (!least || demand.isLess(*least)) {
        least = demand;
        best = gearbox.elements;
      }
    }
    more = false;
    for (std::size_t i = 0; i < at.size() && !more; ++i) {
      more = ++at[i] < classes[i].variants.size();
      if (!more) at[i] = 0;
    }
  }
  gearbox.elements = std::move(best);
  return least.has_value();
}

/// Brakes first, then by links.
void sortElements(Gearbox& gearbox, const std::vector<ElementClass>& classes) {
  std::vector<std::size_t> order(gearbox.elements.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const ElementLinks& x = gearbox.elements[a];
    const ElementLinks& y = gearbox.elements[b];
    return x.isBrake() != y.isBrake() ? x.isBrake() : x < y;
  });
  std::vector<int> places(order.size());
  std::vector<ElementLinks> elements;
  for (std::size_t i = 0; i < order.size(); ++i) {
    places[order[i]] = static_cast<int>(i);
    elements.push_back(gearbox.elements[order[i]]);
    gearbox.variants.push_back(classes[order[i]].variants);
  }
  gearbox.elements = std::move(elements);
  for (GearState& gear : gearbox.gears) {
    for (int& each : gear.engaged) each = places[static_cast<std::size_t>(each)];
    std::sort(gear.engaged.begin(), gear.engaged.end());
  }
}

/// Adds the powers of a gear through the members of all sets; carrier and ring of a Ravigneaux set have the
/// torques of both its parts.
void addPowers(const BasicSets& sets, const GearLayout& layout, const std::vector<Rational>& k,
               const GearBalance<Rational>& balance, Rational& most) {
  Rational ringTorque;
  Rational carrierTorque;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const Rational& sun = balance.suns[set];
    const Rational ring = sets[set].isDouble ? -k[set] * sun : k[set] * sun;
    if (!sets[set].sharesRing) ringTorque = carrierTorque = 0;
    ringTorque += ring;
    carrierTorque -= sun + ring;
    const auto powerOf = [&](SetMember member, const Rational& torque) {
      most = std::max(
          most,
          (torque * balance.speeds[static_cast<std::size_t>(layout.link(static_cast<int>(set), member))])
              .abs());
    };
    powerOf(SetMember::sun, sun);
    if (set + 1 < sets.size() && sets[set + 1].sharesRing) continue;  // with those of the second part
    powerOf(SetMember::ring, ringTorque);
    powerOf(SetMember::carrier, carrierTorque);
  }
}

/// Fills the measures of every gear. False where a gear has another ratio than it states.
bool measure(const BasicSets& sets, int shafts, Gearbox& gearbox) {
  const std::vector<Rational> k = ringRatios(gearbox.teeth);
  const auto raise = [](Rational& most, const Rational& value) { most = std::max(most, value.abs()); };
  for (GearState& gear : gearbox.gears) {
    const auto balance = gearBalance<FractionNumbers>(sets, gearbox.layout, shafts, k,
                                                      engagedOf(gearbox.elements, gear), FractionNumbers());
    if (!balance || balance->ratio != gear.ratio) return false;
    GearMeasures& own = gear.measures;
    for (const Rational& each : balance->elements) raise(own.torque, each);
    for (const Rational& each : balance->speeds) raise(own.speed, each);
    for (const ElementLinks& each : gearbox.elements)
      raise(own.slip, balance->speeds[each.a] - balance->speeds[each.b]);
    addPowers(sets, gearbox.layout, k, *balance, own.power);
    raise(gearbox.measures.torque, own.torque);
    raise(gearbox.measures.speed, own.speed);
    raise(gearbox.measures.slip, own.slip);
    raise(gearbox.measures.power, own.power);
  }
  return true;
}

bool meetsLimits(const GearboxWish& wish, const Gearbox& gearbox) {
  const GearMeasures& measures = gearbox.measures;
  if (wish.torque && measures.torque > *wish.torque) return false;
  if (wish.speed && measures.speed > *wish.speed) return false;
  if (wish.slip && measures.slip > *wish.slip) return false;
  if (wish.isBuildable && gearbox.brokenRule) return false;
  if (wish.spread) {
    const Rational spread = gearbox.gears.front().ratio / gearbox.gears[wish.forward.size() - 1].ratio;
    if (spread < *wish.spread) return false;
  }
  return true;
}

}  // namespace

JudgeCounts& JudgeCounts::operator+=(const JudgeCounts& other) {
  candidates += other.candidates;
  teeth += other.teeth;
  elements += other.elements;
  limits += other.limits;
  return *this;
}

std::optional<Gearbox> judged(const GearboxWish& wish, const GearboxCandidate& candidate,
                              JudgeCounts& counts) {
  ++counts.candidates;
  const BasicSets sets = basicSets(wish.limits.kinds);
  Gearbox gearbox;
  gearbox.layout = candidate.layout;
  if (!LayoutTeeth(wish, candidate).choose(gearbox.teeth, gearbox.gears)) return std::nullopt;
  ++counts.teeth;
  if (!chooseVariants(wish, sets, candidate.elements, gearbox)) return std::nullopt;
  ++counts.elements;
  sortElements(gearbox, candidate.elements);
  for (const GearState& each : gearbox.gears) gearbox.error = std::max(gearbox.error, each.error);
  gearbox.brokenRule = brokenSectionRule(sets, gearbox.layout, wish.limits.shafts, gearbox.elements);
  if (!measure(sets, wish.limits.shafts, gearbox)) return std::nullopt;
  if (!meetsLimits(wish, gearbox)) return std::nullopt;
  ++counts.limits;
  return gearbox;
}

std::optional<Gearbox> evaluated(const GearboxWish& wish, Gearbox gearbox) {
  const BasicSets sets = basicSets(wish.limits.kinds);
  const bool hasReverse = wish.reverse != ReverseWish::none;
  if (gearbox.gears.size() != wish.forward.size() + (hasReverse ? 1 : 0)) return std::nullopt;
  const std::vector<ElementClass> classes = elementClasses(sets, gearbox.layout, wish.limits.shafts);
  for (const ElementLinks& element : gearbox.elements) {
    const auto own = std::find_if(classes.begin(), classes.end(), [&](const ElementClass& each) {
      return std::find(each.variants.begin(), each.variants.end(), element) != each.variants.end();
    });
    if (own == classes.end()) return std::nullopt;
    gearbox.variants.push_back(own->variants);
  }
  for (std::size_t i = 0; i < gearbox.teeth.size(); ++i) {
    TeethOption& option = gearbox.teeth[i];
    for (int planets = kMinPlanets; planets <= kMaxPlanets; ++planets) {
      if (planetsFit(wish.limits.kinds[i], option.parts, planets)) option.planets.push_back(planets);
    }
    if (option.planets.empty()) return std::nullopt;
  }
  const std::vector<Rational> k = ringRatios(gearbox.teeth);
  for (std::size_t gear = 0; gear < gearbox.gears.size(); ++gear) {
    GearState& state = gearbox.gears[gear];
    const auto balance = gearBalance<FractionNumbers>(sets, gearbox.layout, wish.limits.shafts, k,
                                                      engagedOf(gearbox.elements, state), FractionNumbers());
    if (!balance) return std::nullopt;
    state.name = gearName(wish, gear);
    state.ratio = balance->ratio;
    if ((state.ratio.sign() < 0) != (gear >= wish.forward.size())) return std::nullopt;
    if (const WantedRatio* wanted = wantedOf(wish, gear)) {
      if (!wanted->admits(state.ratio.abs())) return std::nullopt;
      state.error = wanted->errorOf(state.ratio.abs());
    }
    gearbox.error = std::max(gearbox.error, state.error);
  }
  gearbox.brokenRule = brokenSectionRule(sets, gearbox.layout, wish.limits.shafts, gearbox.elements);
  if (!measure(sets, wish.limits.shafts, gearbox) || !meetsLimits(wish, gearbox)) return std::nullopt;
  return gearbox;
}

std::optional<Gearbox> withVariant(const GearboxWish& wish, const Gearbox& gearbox, std::size_t position,
                                   const ElementLinks& element) {
  Gearbox changed;
  changed.layout = gearbox.layout;
  changed.elements = gearbox.elements;
  changed.elements[position] = element;
  for (const GearState& each : gearbox.gears) changed.gears.emplace_back().engaged = each.engaged;
  for (const TeethOption& each : gearbox.teeth) changed.teeth.emplace_back().parts = each.parts;
  return evaluated(wish, std::move(changed));
}

bool ranksBefore(const Gearbox& a, const Gearbox& b) {
  const auto keyOf = [](const Gearbox& each) {
    return std::tuple(each.elements.size(), each.brokenRule.has_value());
  };
  if (keyOf(a) != keyOf(b)) return keyOf(a) < keyOf(b);
  if (a.error != b.error) return a.error < b.error;
  if (a.measures.power != b.measures.power) return a.measures.power < b.measures.power;
  if (a.measures.torque != b.measures.torque) return a.measures.torque < b.measures.torque;
  if (a.layout != b.layout) return a.layout < b.layout;
  if (a.elements != b.elements) return a.elements < b.elements;
  for (std::size_t gear = 0; gear < std::min(a.gears.size(), b.gears.size()); ++gear) {
    if (a.gears[gear].engaged != b.gears[gear].engaged) return a.gears[gear].engaged < b.gears[gear].engaged;
  }
  return a.teeth < b.teeth;
}

}  // namespace geargraph
