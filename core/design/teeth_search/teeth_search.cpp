#include "core/design/teeth_search/teeth_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr std::int64_t kFar = std::int64_t{1} << 40U;  // beyond every number of teeth

std::int64_t clamped(WideInteger value) {
  return static_cast<std::int64_t>(
      std::clamp<WideInteger>(value, -static_cast<WideInteger>(kFar), static_cast<WideInteger>(kFar)));
}

/// Rounded down, within +-kFar. @pre by > 0
std::int64_t floorQuotient(std::int64_t of, std::int64_t by) {
  return std::clamp(of / by - (of % by < 0 ? 1 : 0), -kFar, kFar);
}
std::int64_t floorQuotient(WideInteger of, WideInteger by) {
  WideInteger quotient = of / by;
  if (of % by < 0) --quotient;
  return clamped(quotient);
}
std::int64_t floorQuotient(const Rational& of, const Rational& by) {
  const Rational quotient = of / by;
  if (quotient >= Rational(kFar)) return kFar;
  if (quotient <= Rational(-kFar)) return -kFar;
  fmpz_t whole;
  fmpz_init(whole);
  fmpz_fdiv_q(whole, fmpq_numref(quotient.flint()), fmpq_denref(quotient.flint()));
  const std::int64_t result = fmpz_get_si(whole);
  fmpz_clear(whole);
  return result;
}

/// first <= x <= last.
struct Stretch {
  std::int64_t first = 0;
  std::int64_t last = 0;

  [[nodiscard]] bool isEmpty() const { return first > last; }
  [[nodiscard]] std::int64_t size() const { return isEmpty() ? 0 : last - first + 1; }
  [[nodiscard]] bool contains(std::int64_t x) const { return first <= x && x <= last; }
};

/// A whole number for each x: at0 + slope x.
template <class BigInteger>
struct Line {
  BigInteger at0 = 0;
  BigInteger slope = 0;

  [[nodiscard]] Line negated() const { return {-at0, -slope}; }
  /// factor * this - otherFactor * other.
  [[nodiscard]] Line combined(const BigInteger& factor, const Line& other,
                              const BigInteger& otherFactor) const {
    return {factor * at0 - otherFactor * other.at0, factor * slope - otherFactor * other.slope};
  }
};

/// The part of the stretch where the line is at least `least`. Divides only where an end lies inside.
template <class BigInteger>
Stretch whereAtLeast(const Line<BigInteger>& line, int least, Stretch in) {
  if (in.isEmpty()) return in;
  const BigInteger rest = line.at0 - BigInteger(least);
  const bool firstIs = rest + line.slope * BigInteger(in.first) >= BigInteger(0);
  const bool lastIs = rest + line.slope * BigInteger(in.last) >= BigInteger(0);
  if (firstIs && lastIs) return in;
  if (!firstIs && !lastIs) return {1, 0};
  if (lastIs) {
    in.first = -floorQuotient(rest, line.slope);
  } else {
    in.last = floorQuotient(rest, -line.slope);
  }
  return in;
}

/// The x at which the line is 0, if it is one of the stretch.
template <class BigInteger>
std::optional<std::int64_t> zeroOf(const Line<BigInteger>& line, const Stretch& in) {
  if (line.slope == BigInteger(0)) return std::nullopt;
  const Line<BigInteger> up = line.slope > BigInteger(0) ? line : line.negated();
  if (up.at0 + up.slope * BigInteger(in.first) > BigInteger(0) ||
      up.at0 + up.slope * BigInteger(in.last) < BigInteger(0))
    return std::nullopt;
  const std::int64_t x = floorQuotient(-up.at0, up.slope);
  if (!in.contains(x) || up.at0 + up.slope * BigInteger(x) != BigInteger(0)) return std::nullopt;
  return x;
}

/// The order in which wheels get their teeth, and which conditions are decided with each.
struct WheelOrder {
  std::vector<int> wheels;
  std::vector<int> placeOf;  ///< by wheel
  std::vector<int> free;     ///< places of wheels that no condition determines, kept ones aside
};

WheelOrder orderOf(const TeethProblem& problem, int lastFree) {
  WheelOrder order;
  const auto count = problem.wheels.size();
  order.placeOf.assign(count, -1);
  const auto append = [&](int wheel) {
    order.placeOf[static_cast<std::size_t>(wheel)] = static_cast<int>(order.wheels.size());
    order.wheels.push_back(wheel);
  };
  const auto isPlaced = [&](int wheel) { return order.placeOf[static_cast<std::size_t>(wheel)] >= 0; };
  /// A wheel that a condition determines once those placed and `assumed` are known; -1: none.
  const auto determined = [&](const std::vector<char>& known) {
    for (const SumCondition& sum : problem.sums) {
      if (sum.low != sum.high) continue;
      int open = -1;
      int opens = 0;
      for (const SumCondition::Term& term : sum.terms) {
        if (known[static_cast<std::size_t>(term.wheel)] != 0) continue;
        open = term.wheel;
        ++opens;
      }
      if (opens == 1) return open;
    }
    return -1;
  };
  std::vector<char> known(count, 0);
  for (std::size_t wheel = 0; wheel < count; ++wheel) {
    if (!problem.wheels[wheel].isKept) continue;
    append(static_cast<int>(wheel));
    known[wheel] = 1;
  }
  while (order.wheels.size() < count) {
    if (const int next = determined(known); next >= 0) {
      append(next);
      known[static_cast<std::size_t>(next)] = 1;
      continue;
    }
    int best = -1;
    std::size_t bestFollowing = 0;
    for (std::size_t wheel = 0; wheel < count; ++wheel) {
      if (isPlaced(static_cast<int>(wheel))) continue;
      std::vector<char> then = known;
      then[wheel] = 1;
      std::size_t following = 1;
      for (int next = determined(then); next >= 0; next = determined(then), ++following)
        then[static_cast<std::size_t>(next)] = 1;
      const bool isLast = static_cast<int>(wheel) == lastFree;
      const bool wasLast = best == lastFree && best >= 0;
      const bool isBetter =
          best < 0 || (wasLast && !isLast) ||
          (wasLast == isLast &&
           (following > bestFollowing || (following == bestFollowing &&
                                          problem.wheels[wheel].counts.size() <
                                              problem.wheels[static_cast<std::size_t>(best)].counts.size())));
      if (!isBetter) continue;
      best = static_cast<int>(wheel);
      bestFollowing = following;
    }
    order.free.push_back(static_cast<int>(order.wheels.size()));
    append(best);
    known[static_cast<std::size_t>(best)] = 1;
  }
  return order;
}

bool isGapless(const SearchedWheel& wheel) {
  return !wheel.counts.empty() &&
         wheel.counts.back() - wheel.counts.front() + 1 == static_cast<int>(wheel.counts.size());
}

/// Whether, with this order, the ratios are Moebius functions of the last free wheel that can be inverted.
bool canInvertLast(const TeethProblem& problem, const WheelOrder& order) {
  if (order.free.empty() || problem.hasPlanets() || !problem.closures.empty() || problem.wish.onlyHunting ||
      !problem.wish.allowsUndercut || problem.wish.usesStockOnce)
    return false;
  const int last = order.free.back();
  const auto follows = [&](int wheel) { return order.placeOf[static_cast<std::size_t>(wheel)] >= last; };
  for (std::size_t place = static_cast<std::size_t>(last); place < order.wheels.size(); ++place)
    if (!isGapless(problem.wheels[static_cast<std::size_t>(order.wheels[place])])) return false;
  for (std::size_t place = static_cast<std::size_t>(last) + 1; place < order.wheels.size(); ++place) {
    const int wheel = order.wheels[place];
    const bool isUnit = std::any_of(problem.sums.begin(), problem.sums.end(), [&](const SumCondition& sum) {
      bool isOwn = false;
      for (const SumCondition::Term& term : sum.terms) {
        if (order.placeOf[static_cast<std::size_t>(term.wheel)] > static_cast<int>(place)) return false;
        if (term.wheel == wheel) isOwn = std::abs(term.factor) == 1;
      }
      return isOwn && sum.low == sum.high;
    });
    if (!isUnit) return false;
  }
  for (const SearchedRatio& ratio : problem.ratios) {
    for (const TeethPolynomial* each : {&ratio.numerator, &ratio.denominator}) {
      for (const TeethPolynomial::Term& term : each->terms)
        if (std::count_if(term.wheels.begin(), term.wheels.end(), follows) > 1) return false;
    }
  }
  return true;
}

/// One search with whole numbers of one kind.
template <class BigInteger>
class Search {
 public:
  Search(const TeethProblem& problem, WheelOrder order, bool invertsLast, const TeethSearchOptions& options,
         const std::stop_token& stop)
      : m_problem(problem),
        m_order(std::move(order)),
        m_invertsLast(invertsLast),
        m_options(options),
        m_stop(stop),
        m_best(problem, options.most),
        m_teeth(problem.wheels.size(), 0) {
    for (const SearchedRatio& ratio : problem.ratios) m_bounds.push_back(boundsOf(ratio.bounds));
    sortConditions();
    for (const int teeth : problem.wish.stock) ++m_stock[teeth];
  }

  TeethFound run() {
    const bool isThere = std::none_of(m_problem.wheels.begin(), m_problem.wheels.end(),
                                      [](const SearchedWheel& wheel) { return wheel.counts.empty(); });
    if (isThere) go(0, {});
    closeBranch();
    m_found.isComplete = !m_stopped;
    m_found.order = m_order.wheels;
    if (!m_order.free.empty()) m_found.first = m_order.wheels[static_cast<std::size_t>(m_order.free.front())];
    for (const TeethBranch& branch : m_found.branches) m_found.counts += branch.counts;
    m_found.best = std::move(m_best).take();
    if (m_found.counts.accepted == 0) m_found.nearest = std::move(m_nearest);
    return std::move(m_found);
  }

 private:
  struct Bounds {
    BigInteger lowOver, lowUnder, highOver, highUnder;  ///< denominators above 0
    bool includesHigh = true;
  };
  /// Conditions that wheels so far decide.
  struct Standing {
    bool clears = true;
    bool assembles = true;
    bool hunts = true;
    bool stands = true;
  };
  struct AtPlace {
    std::vector<const SumCondition*> sums;
    std::vector<const PlanetCondition*> planets;
    std::vector<std::pair<int, int>> pairs;  ///< wheels of meshes
    bool isFree = false;
  };

  static BigInteger wholeOf(const fmpz* value) {
    if constexpr (std::is_same_v<BigInteger, Rational>) {
      Rational whole;
      fmpz_set(fmpq_numref(whole.flint()), value);
      return whole;
    } else {
      return static_cast<BigInteger>(fmpz_get_si(value));
    }
  }
  static Bounds boundsOf(const RatioBounds& of) {
    const fmpq* low = of.low.flint();
    const fmpq* high = of.high.flint();
    return {wholeOf(fmpq_numref(low)), wholeOf(fmpq_denref(low)), wholeOf(fmpq_numref(high)),
            wholeOf(fmpq_denref(high)), of.includesHigh};
  }

  void sortConditions() {
    m_places.resize(m_order.wheels.size());
    const auto placeOf = [&](int wheel) { return m_order.placeOf[static_cast<std::size_t>(wheel)]; };
    for (const SumCondition& sum : m_problem.sums) {
      int last = 0;
      for (const SumCondition::Term& term : sum.terms) last = std::max(last, placeOf(term.wheel));
      m_places[static_cast<std::size_t>(last)].sums.push_back(&sum);
    }
    for (const PlanetCondition& set : m_problem.planets) {
      if (set.wheels().empty() || (m_problem.planetsOf(set) < 2 && !set.hasTriangle())) continue;
      int last = 0;
      for (const int wheel : set.wheels()) last = std::max(last, placeOf(wheel));
      m_places[static_cast<std::size_t>(last)].planets.push_back(&set);
    }
    for (std::size_t end = 0; end < m_problem.wheelOfEnd.size(); end += 2) {
      const auto [tail, head] = std::pair(m_problem.wheelOfEnd[end], m_problem.wheelOfEnd[end + 1]);
      if (isKept(tail) && isKept(head)) continue;
      m_places[static_cast<std::size_t>(std::max(placeOf(tail), placeOf(head)))].pairs.emplace_back(tail,
                                                                                                    head);
    }
    for (const int place : m_order.free) m_places[static_cast<std::size_t>(place)].isFree = true;
    m_firstFree = m_order.free.empty() ? 0 : static_cast<std::size_t>(m_order.free.front());
  }
  [[nodiscard]] bool isKept(int wheel) const {
    return m_problem.wheels[static_cast<std::size_t>(wheel)].isKept;
  }

  [[nodiscard]] int at(int wheel) const { return m_teeth[static_cast<std::size_t>(wheel)]; }

  /// The teeth that the conditions leave for the wheel at this place.
  [[nodiscard]] Stretch roomAt(std::size_t place) const {
    const int wheel = m_order.wheels[place];
    const SearchedWheel& of = m_problem.wheels[static_cast<std::size_t>(wheel)];
    Stretch room{of.counts.front(), of.counts.back()};
    for (const SumCondition* sum : m_places[place].sums) {
      Line<WideInteger> line;
      for (const SumCondition::Term& term : sum->terms) {
        if (term.wheel == wheel) {
          line.slope += term.factor;
        } else {
          line.at0 += static_cast<WideInteger>(term.factor) * at(term.wheel);
        }
      }
      const WideInteger low = sum->low, high = sum->high;
      room = whereAtLeast<WideInteger>({line.at0 - low, line.slope}, 0, room);
      room = whereAtLeast<WideInteger>({high - line.at0, -line.slope}, 0, room);
    }
    return room;
  }

  void go(std::size_t place, Standing standing) {
    if (place == m_order.wheels.size()) return leaf(standing);
    if (m_stop.stop_requested()) m_stopped = true;
    if (m_stopped) return;
    if (m_invertsLast && place == static_cast<std::size_t>(m_order.free.back())) return slice(place);
    const int wheel = m_order.wheels[place];
    const SearchedWheel& of = m_problem.wheels[static_cast<std::size_t>(wheel)];
    const Stretch room = roomAt(place);
    if (room.isEmpty()) return;
    const auto end = std::upper_bound(of.counts.begin(), of.counts.end(), static_cast<int>(room.last));
    for (auto teeth = std::lower_bound(of.counts.begin(), of.counts.end(), static_cast<int>(room.first));
         teeth < end && !m_stopped; ++teeth) {
      if (m_problem.wish.usesStockOnce && !of.isKept && !takeFromStock(*teeth, of.copies)) continue;
      m_teeth[static_cast<std::size_t>(wheel)] = *teeth;
      const bool isBranch = place == m_firstFree && m_places[place].isFree;
      if (isBranch) openBranch(*teeth);
      go(place + 1, judged(place, standing));
      if (isBranch && !m_stopped) tell(of, *teeth);
      if (isBranch && m_stop.stop_requested()) m_stopped = true;
      if (m_problem.wish.usesStockOnce && !of.isKept) m_stock[*teeth] += of.copies;
    }
  }

  bool takeFromStock(int teeth, int copies) {
    int& left = m_stock[teeth];
    if (left < copies) return false;
    left -= copies;
    return true;
  }

  void openBranch(int teeth) {
    closeBranch();
    m_branch = TeethBranch{teeth, {}};
  }
  void closeBranch() {
    if (m_branch.counts.tried > 0 || m_branch.teeth > 0) m_found.branches.push_back(m_branch);
    m_total += m_branch.counts.accepted;
    m_branch = {};
  }
  void tell(const SearchedWheel& first, int teeth) const {
    if (!m_options.progress) return;
    const int from = first.counts.front(), to = first.counts.back();
    m_options.progress(static_cast<double>(teeth - from + 1) / (to - from + 1),
                       m_total + m_branch.counts.accepted);
  }

  [[nodiscard]] Standing judged(std::size_t place, Standing standing) const {
    const AtPlace& here = m_places[place];
    for (const PlanetCondition* set : here.planets) {
      if (!standing.clears) return standing;
      const int planets = m_problem.planetsOf(*set);
      standing.clears = set->clears(m_teeth, planets);
      if (standing.clears && standing.assembles) standing.assembles = set->assembles(m_teeth, planets);
    }
    if (m_problem.wish.onlyHunting) {
      for (const auto& [one, other] : here.pairs)
        if (std::gcd(at(one), at(other)) != 1) standing.hunts = false;
    }
    if (!m_problem.wish.allowsUndercut && isUndercut(m_order.wheels[place])) standing.stands = false;
    return standing;
  }
  [[nodiscard]] bool isUndercut(int wheel) const {
    const SearchedWheel& of = m_problem.wheels[static_cast<std::size_t>(wheel)];
    return !of.isKept && of.isUndercutWith(at(wheel));
  }

  void leaf(const Standing& standing) {
    TeethCounts& counts = m_branch.counts;
    ++counts.tried;
    for (const TeethPolynomial& closure : m_problem.closures)
      if (closure.template at<BigInteger>(m_teeth) != BigInteger(0)) return;
    m_values.clear();
    for (const SearchedRatio& ratio : m_problem.ratios) {
      m_values.emplace_back(ratio.numerator.template at<BigInteger>(m_teeth),
                            ratio.denominator.template at<BigInteger>(m_teeth));
      if (m_values.back().first == BigInteger(0) || m_values.back().second == BigInteger(0)) return;
    }
    ++counts.turns;
    if (!standing.clears) return;
    ++counts.clears;
    if (!standing.assembles) return;
    ++counts.assembles;
    if (!standing.hunts) return;
    ++counts.hunts;
    if (!standing.stands) return;
    ++counts.stands;
    bool isWithin = true;
    for (std::size_t i = 0; i < m_values.size() && isWithin; ++i)
      isWithin = contains(m_bounds[i], m_values[i].first, m_values[i].second);
    isWithin ? hit() : miss();
  }

  static bool contains(const Bounds& bounds, BigInteger numerator, BigInteger denominator) {
    if (denominator < BigInteger(0)) {
      numerator = -numerator;
      denominator = -denominator;
    }
    if (numerator * bounds.lowUnder < bounds.lowOver * denominator) return false;
    const BigInteger one = numerator * bounds.highUnder, other = bounds.highOver * denominator;
    return bounds.includesHigh ? one <= other : one < other;
  }

  void hit() {
    ++m_branch.counts.within;
    if (m_options.accepts && !m_options.accepts(m_teeth)) return;
    ++m_branch.counts.accepted;
    m_best.offer(m_teeth);
  }

  /// Remembers the nearest of those that are outside of the bounds, as long as none is inside.
  void miss() {
    if (m_total + m_branch.counts.accepted > 0) return;
    const double error = nearError(m_problem, m_teeth);
    if (error >= m_nearestError) return;
    m_nearestError = error;
    m_nearest = foundTeeth(m_problem, m_teeth);
  }

  /// The teeth of the last free wheel and of those that follow it are lines in x.
  void slice(std::size_t place) {
    const int wheel = m_order.wheels[place];
    const SearchedWheel& of = m_problem.wheels[static_cast<std::size_t>(wheel)];
    Stretch room{of.counts.front(), of.counts.back()};
    const bool isBranch = place == m_firstFree;
    std::vector<int>& at0 = m_at0;
    std::vector<int>& at1 = m_at1;
    at0 = m_teeth;
    at1 = m_teeth;
    at0[static_cast<std::size_t>(wheel)] = 0;
    at1[static_cast<std::size_t>(wheel)] = 1;
    for (std::size_t each = place; each < m_order.wheels.size(); ++each) {
      const int own = m_order.wheels[each];
      if (each > place) follow(each, own);
      const SearchedWheel& follower = m_problem.wheels[static_cast<std::size_t>(own)];
      const Line<WideInteger> teeth{at0[static_cast<std::size_t>(own)],
                                    at1[static_cast<std::size_t>(own)] - at0[static_cast<std::size_t>(own)]};
      room = whereAtLeast<WideInteger>(teeth, follower.counts.front(), room);
      room = whereAtLeast<WideInteger>(teeth.negated(), -follower.counts.back(), room);
      for (const SumCondition* sum : m_places[each].sums) {
        const auto [value, next] = valuesOf(*sum);
        room = whereAtLeast<WideInteger>({value - sum->low, next - value}, 0, room);
        room = whereAtLeast<WideInteger>({sum->high - value, value - next}, 0, room);
      }
    }
    if (isBranch) {
      m_branch.teeth = of.counts.front();  // one branch: there is no other free wheel
    }
    if (room.isEmpty()) return;
    judgeSlice(place, room);
  }

  /// Sets the wheel that an equation determines at x = 0 and x = 1.
  void follow(std::size_t place, int wheel) {
    for (const SumCondition* sum : m_places[place].sums) {
      if (sum->low != sum->high) continue;
      int factor = 0;
      std::int64_t rest0 = sum->low, rest1 = sum->low;
      for (const SumCondition::Term& term : sum->terms) {
        if (term.wheel == wheel) {
          factor = term.factor;
          continue;
        }
        rest0 -= std::int64_t{term.factor} * m_at0[static_cast<std::size_t>(term.wheel)];
        rest1 -= std::int64_t{term.factor} * m_at1[static_cast<std::size_t>(term.wheel)];
      }
      if (std::abs(factor) != 1) continue;
      m_at0[static_cast<std::size_t>(wheel)] = static_cast<int>(factor * rest0);
      m_at1[static_cast<std::size_t>(wheel)] = static_cast<int>(factor * rest1);
      return;
    }
    GEARGRAPH_REQUIRE(false);  // canInvertLast()
  }
  [[nodiscard]] std::pair<WideInteger, WideInteger> valuesOf(const SumCondition& sum) const {
    WideInteger value = 0, next = 0;
    for (const SumCondition::Term& term : sum.terms) {
      value += static_cast<WideInteger>(term.factor) * m_at0[static_cast<std::size_t>(term.wheel)];
      next += static_cast<WideInteger>(term.factor) * m_at1[static_cast<std::size_t>(term.wheel)];
    }
    return {value, next};
  }

  using WholeLine = Line<BigInteger>;
  [[nodiscard]] WholeLine lineOf(const TeethPolynomial& polynomial) const {
    const BigInteger at0 = polynomial.at<BigInteger>(m_at0);
    return {at0, polynomial.at<BigInteger>(m_at1) - at0};
  }

  void judgeSlice(std::size_t place, const Stretch& room) {
    TeethCounts& counts = m_branch.counts;
    counts.tried += room.size();
    m_zeros.clear();
    std::vector<Stretch>& hits = m_hits;
    for (std::size_t i = 0; i < m_problem.ratios.size(); ++i) {
      const WholeLine numerator = lineOf(m_problem.ratios[i].numerator);
      const WholeLine denominator = lineOf(m_problem.ratios[i].denominator);
      for (const WholeLine* line : {&numerator, &denominator}) {
        if (line->slope == BigInteger(0) && line->at0 == BigInteger(0)) return;  // stands still for every x
        if (const auto zero = zeroOf(*line, room)) m_zeros.push_back(*zero);
      }
      if (i == 0) hits = hitsOf(m_bounds[i], numerator, denominator, room);
      if (i == 0 && m_total + counts.accepted == 0 && m_problem.ratios.size() == 1)
        missNear(place, numerator, denominator, room);
    }
    std::sort(m_zeros.begin(), m_zeros.end());
    m_zeros.erase(std::unique(m_zeros.begin(), m_zeros.end()), m_zeros.end());
    const std::int64_t turning = room.size() - static_cast<std::int64_t>(m_zeros.size());
    for (std::int64_t* count :
         {&counts.turns, &counts.clears, &counts.assembles, &counts.hunts, &counts.stands})
      *count += turning;
    for (const Stretch& stretch : hits) {
      for (std::int64_t x = stretch.first; x <= stretch.last; ++x) {
        setTeeth(place, x);
        bool isWithin = true;
        for (std::size_t i = 1; i < m_problem.ratios.size() && isWithin; ++i) {
          const auto numerator = m_problem.ratios[i].numerator.template at<BigInteger>(m_teeth);
          const auto denominator = m_problem.ratios[i].denominator.template at<BigInteger>(m_teeth);
          isWithin = numerator != BigInteger(0) && denominator != BigInteger(0) &&
                     contains(m_bounds[i], numerator, denominator);
        }
        if (isWithin) hit();
      }
    }
  }

  void setTeeth(std::size_t place, std::int64_t x) {
    for (std::size_t each = place; each < m_order.wheels.size(); ++each) {
      const auto wheel = static_cast<std::size_t>(m_order.wheels[each]);
      m_teeth[wheel] = static_cast<int>(m_at0[wheel] + x * (m_at1[wheel] - m_at0[wheel]));
    }
  }

  /// Where the quotient is within the bounds: at most one stretch for each sign of the denominator.
  static std::vector<Stretch> hitsOf(const Bounds& bounds, const WholeLine& numerator,
                                     const WholeLine& denominator, const Stretch& room) {
    std::vector<Stretch> hits;
    for (const bool isNegative : {false, true}) {
      const WholeLine over = isNegative ? numerator.negated() : numerator;
      const WholeLine under = isNegative ? denominator.negated() : denominator;
      Stretch stretch = whereAtLeast(under, 1, room);
      stretch = whereAtLeast(over.combined(bounds.lowUnder, under, bounds.lowOver), 0, stretch);
      stretch = whereAtLeast(under.combined(bounds.highOver, over, bounds.highUnder),
                             bounds.includesHigh ? 0 : 1, stretch);
      if (!stretch.isEmpty()) hits.push_back(stretch);
    }
    return hits;
  }

  /// A Moebius function is monotonic on both sides of its pole: its nearest values are beside the place where
  /// it would have the wanted one, beside the pole, or at the ends.
  void missNear(std::size_t place, const WholeLine& numerator, const WholeLine& denominator,
                const Stretch& room) {
    std::vector<std::int64_t> beside{room.first, room.last};
    const RatioBounds& bounds = m_problem.ratios.front().bounds;
    const double wanted = bounds.wanted.toDouble();
    const auto add = [&](double at) {
      if (!std::isfinite(at)) return;
      const auto x = static_cast<std::int64_t>(std::floor(std::clamp(at, -1e12, 1e12)));
      for (const std::int64_t each : {x - 1, x, x + 1, x + 2})
        if (room.contains(each)) beside.push_back(each);
    };
    const auto number = [](const BigInteger& value) {
      if constexpr (std::is_same_v<BigInteger, Rational>) {
        return value.toDouble();
      } else {
        return static_cast<double>(value);
      }
    };
    add((wanted * number(denominator.at0) - number(numerator.at0)) /
        (number(numerator.slope) - wanted * number(denominator.slope)));
    add(-number(denominator.at0) / number(denominator.slope));
    for (const std::int64_t x : beside) {
      setTeeth(place, x);
      const double error = nearError(m_problem, m_teeth);
      if (!(error < m_nearestError)) continue;
      const FoundTeeth found = foundTeeth(m_problem, m_teeth);
      if (bounds.contains(found.ratios.front())) continue;
      m_nearestError = error;
      m_nearest = found;
    }
  }

  const TeethProblem& m_problem;
  WheelOrder m_order;
  bool m_invertsLast;
  const TeethSearchOptions& m_options;
  std::stop_token m_stop;
  BestChoices m_best;
  std::vector<int> m_teeth;
  std::vector<Bounds> m_bounds;
  std::vector<AtPlace> m_places;
  std::map<int, int> m_stock;
  std::size_t m_firstFree = 0;
  bool m_stopped = false;
  TeethBranch m_branch;
  std::int64_t m_total = 0;  ///< accepted in earlier branches
  TeethFound m_found;
  std::optional<FoundTeeth> m_nearest;
  double m_nearestError = std::numeric_limits<double>::infinity();
  std::vector<std::pair<BigInteger, BigInteger>> m_values;
  std::vector<int> m_at0, m_at1;
  std::vector<std::int64_t> m_zeros;
  std::vector<Stretch> m_hits;
};

/// No product of the search is larger; infinite where a bound does not fit into 64 bits.
double largestProduct(const TeethProblem& problem) {
  std::vector<int> largest;
  for (const SearchedWheel& wheel : problem.wheels)
    largest.push_back(wheel.counts.empty() ? 1 : wheel.counts.back());
  for (int& teeth : largest) teeth = 3 * teeth + 3;  // lines are read at x = 0, beyond the limits
  double size = 1;
  for (const SearchedRatio& ratio : problem.ratios) {
    for (const Rational* bound : {&ratio.bounds.low, &ratio.bounds.high}) {
      const fmpq* value = bound->flint();
      if (fmpz_fits_si(fmpq_numref(value)) == 0 || fmpz_fits_si(fmpq_denref(value)) == 0)
        return std::numeric_limits<double>::infinity();
      const double scale = std::max(std::abs(fmpz_get_d(fmpq_numref(value))), fmpz_get_d(fmpq_denref(value)));
      size = std::max(size, scale * (ratio.numerator.sizeAt(largest) + ratio.denominator.sizeAt(largest)));
    }
  }
  for (const TeethPolynomial& closure : problem.closures) size = std::max(size, closure.sizeAt(largest));
  return size * kMaxSearchedTeeth;
}

}  // namespace

TeethCounts& TeethCounts::operator+=(const TeethCounts& more) {
  tried += more.tried;
  turns += more.turns;
  clears += more.clears;
  assembles += more.assembles;
  hunts += more.hunts;
  stands += more.stands;
  within += more.within;
  accepted += more.accepted;
  return *this;
}

TeethFound searchTeeth(const TeethProblem& problem, const TeethSearchOptions& options,
                       const std::stop_token& stop) {
  WheelOrder order = orderOf(problem, -1);
  bool invertsLast = canInvertLast(problem, order);
  for (std::size_t wheel = 0; wheel < problem.wheels.size() && !invertsLast; ++wheel) {
    WheelOrder other = orderOf(problem, static_cast<int>(wheel));
    if (!canInvertLast(problem, other)) continue;
    order = std::move(other);
    invertsLast = true;
  }
  constexpr double kMaxShort = 2e18;  // below a quarter of 2^63
  constexpr double kMaxWide = 4e37;   // below a quarter of 2^127
  const double largest = largestProduct(problem);
  if (largest < kMaxShort)
    return Search<std::int64_t>(problem, std::move(order), invertsLast, options, stop).run();
  if (largest < kMaxWide)
    return Search<WideInteger>(problem, std::move(order), invertsLast, options, stop).run();
  return Search<Rational>(problem, std::move(order), invertsLast, options, stop).run();
}

}  // namespace geargraph
