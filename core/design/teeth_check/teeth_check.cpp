#include "core/design/teeth_check/teeth_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

#include "core/design/teeth_check/certificate_reader.h"
#include "core/design/teeth_check/checked_planets.h"
#include "core/design/teeth_wish/problem_mark.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/json_writer.h"
#include "core/mechanism/kinds/pair_kind.h"
#include "core/mechanism/model/pins.h"
#include "core/mechanism/model/validate.h"
#include "core/mechanism/placement/placement.h"
#include "core/theory/states/state_solution.h"

namespace geargraph {
namespace {

__extension__ using Long = __int128;  ///< GCC and clang have it, ISO C++ does not

/// The mechanism with a state for each ratio: what `held`, `state` or neither engage.
Mechanism withStatesOf(const TeethCertificate& certificate) {
  Mechanism train = certificate.mechanism;
  train.states.clear();
  train.engaged.clear();
  for (const RatioWish& wish : certificate.wish.ratios) {
    ShiftState state;
    state.name = "ratio " + std::to_string(train.states.size());
    if (wish.state >= 0)
      state.engaged = certificate.mechanism.states[static_cast<std::size_t>(wish.state)].engaged;
    if (wish.isEngaged) state.engaged = certificate.mechanism.engaged;
    for (const LinkOrdinal link : wish.held) {
      if (link == 0) continue;
      ShiftElement brake;
      brake.id = ShiftElementId("check " + std::to_string(train.couplings.size()));
      brake.links = {train.links[link].id};
      state.engaged.push_back(brake.id);
      train.couplings.push_back(std::move(brake));
    }
    state.drive = train.links[wish.drive].id;
    state.driven = train.links[wish.driven].id;
    train.states.push_back(std::move(state));
  }
  return train;
}

/// The value of a polynomial; none where it does not fit.
std::optional<Long> shortValue(const std::vector<TeethCertificate::Term>& terms, std::span<const int> teeth) {
  Long sum = 0;
  for (const TeethCertificate::Term& term : terms) {
    Long product = term.factor;
    for (const int wheel : term.wheels)
      if (__builtin_mul_overflow(product, static_cast<Long>(teeth[static_cast<std::size_t>(wheel)]),
                                 &product))
        return std::nullopt;
    if (__builtin_add_overflow(sum, product, &sum)) return std::nullopt;
  }
  return sum;
}

Rational longValue(const std::vector<TeethCertificate::Term>& terms, std::span<const int> teeth) {
  Rational sum = 0;
  for (const TeethCertificate::Term& term : terms) {
    Rational product = term.factor;
    for (const int wheel : term.wheels) product *= Rational(teeth[static_cast<std::size_t>(wheel)]);
    sum += product;
  }
  return sum;
}

/// The sign of p/q - bound, q not 0.
int compared(const std::optional<Long>& p, const std::optional<Long>& q, const Rational& bound,
             const TeethCertificate::Ratio& ratio, std::span<const int> teeth) {
  const fmpq* const of = bound.flint();
  if (p && q && fmpz_fits_si(fmpq_numref(of)) != 0 && fmpz_fits_si(fmpq_denref(of)) != 0) {
    Long left = 0, right = 0;
    if (!__builtin_mul_overflow(*p, static_cast<Long>(fmpz_get_si(fmpq_denref(of))), &left) &&
        !__builtin_mul_overflow(*q, static_cast<Long>(fmpz_get_si(fmpq_numref(of))), &right)) {
      const int sign = left < right ? -1 : left > right ? 1 : 0;
      return *q < 0 ? -sign : sign;
    }
  }
  return (longValue(ratio.numerator, teeth) / longValue(ratio.denominator, teeth) - bound).sign();
}

class TeethChecker {
 public:
  TeethChecker(const TeethCertificate& certificate, const Placement& placement, const std::stop_token& stop)
      : m_claim(certificate),
        m_wish(certificate.wish),
        m_mechanism(certificate.mechanism),
        m_placement(placement),
        m_stop(stop),
        m_teeth(certificate.wheels.size(), 0) {}

  TeethVerdict run() {
    m_verdict.choices = m_claim.choices.size();
    if (markOf(m_claim.problem) != m_claim.mark)
      fault(translated("The mark is not that of the problem: it was changed."));
    if (!checkWheels() || !checkRatios()) return std::move(m_verdict);
    setDomains();
    setDistances();
    for (const std::vector<PlanetGroup>& set : planetSets(m_mechanism, m_placement, PlanetScope::all))
      m_planets.emplace_back(m_mechanism, m_placement, set, m_wheelOfEnd);
    if (!m_claim.choices.empty()) {
      m_worst = Rational(0);
      for (const Rational& error : m_claim.choices.back().errors) m_worst = std::max(m_worst, error.abs());
    }
    for (const int teeth : m_wish.stock) ++m_stock[teeth];
    visit(0);
    m_verdict.isComplete = !m_stopped;
    m_verdict.tried = m_total[0];
    m_verdict.within = m_total[6];
    if (m_verdict.isComplete) compareAll();
    return std::move(m_verdict);
  }

 private:
  void fault(std::string sentence) {
    constexpr std::size_t kMaxFaults = 20;
    if (m_verdict.faults.size() < kMaxFaults) m_verdict.faults.push_back(std::move(sentence));
  }

  /// Every end of a mesh on one wheel, all ends of a wheel with the same drawn teeth, every wheel in the
  /// order.
  bool checkWheels() {
    m_wheelOfEnd.assign(2 * m_mechanism.gearMeshes.size(), -1);
    bool isRight = true;
    for (std::size_t wheel = 0; wheel < m_claim.wheels.size(); ++wheel) {
      const std::vector<int>& ends = m_claim.wheels[wheel].ends;
      isRight = isRight && !ends.empty();
      for (const int end : ends) {
        int& at = m_wheelOfEnd[static_cast<std::size_t>(end)];
        isRight = isRight && at < 0 && drawn(end) == drawn(ends.front());
        at = static_cast<int>(wheel);
      }
    }
    isRight = isRight && std::find(m_wheelOfEnd.begin(), m_wheelOfEnd.end(), -1) == m_wheelOfEnd.end();
    std::vector<int> sorted = m_claim.order;
    std::sort(sorted.begin(), sorted.end());
    std::vector<int> all(m_claim.wheels.size());
    std::iota(all.begin(), all.end(), 0);
    if (!isRight || sorted != all) fault(translated("The wheels are not those of the meshes."));
    return isRight && sorted == all;
  }
  [[nodiscard]] int drawn(int end) const {
    const GearMesh& mesh = m_mechanism.gearMeshes[end / 2];
    return end % 2 == 0 ? mesh.tailTeeth : mesh.headTeeth;
  }
  [[nodiscard]] int wheelAt(int end) const { return m_wheelOfEnd[static_cast<std::size_t>(end)]; }

  /// The stated quotients are the ratios of the states.
  bool checkRatios() {
    const Mechanism train = withStatesOf(m_claim);
    std::uint64_t random = 88172645463325252U;
    constexpr int kTrials = 6;
    for (std::size_t i = 0; i < m_claim.ratios.size(); ++i) {
      int compared = 0;
      for (int trial = 0; trial < 4 * kTrials && compared < kTrials; ++trial) {
        std::vector<int> teeth(m_claim.wheels.size());
        for (int& each : teeth) {
          random ^= random << 13U;
          random ^= random >> 7U;
          random ^= random << 17U;
          each = 1 + static_cast<int>(random >> 44U);
        }
        Placement placement = m_placement;
        for (MeshOrdinal mesh = 0; mesh < m_mechanism.c(); ++mesh) {
          placement.meshes[mesh]->tailTeeth = teeth[static_cast<std::size_t>(wheelAt(2 * mesh))];
          placement.meshes[mesh]->headTeeth = teeth[static_cast<std::size_t>(wheelAt(2 * mesh + 1))];
          placement.meshes[mesh]->weights = {placement.meshes[mesh]->tailTeeth,
                                             placement.meshes[mesh]->headTeeth};
        }
        const auto model = KinematicModel::of(placement.tree->graph, placement.tree->tree, placement);
        const auto solved = solveState(train, *model, placement, static_cast<int>(i), false);
        const Rational under = longValue(m_claim.ratios[i].denominator, teeth);
        if (!solved->ratio || under.isZero()) continue;
        if (longValue(m_claim.ratios[i].numerator, teeth) / under != *solved->ratio) {
          fault(translated("Ratio %1 is not that of the mechanism.", {std::to_string(i + 1)}));
          return false;
        }
        ++compared;
      }
      if (compared == 0) {
        fault(translated("Ratio %1 is not that of the mechanism.", {std::to_string(i + 1)}));
        return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool isRingEnd(int end) const {
    return hasRing(m_placement.meshes[end / 2]->kind) && drawn(end) > drawn(end ^ 1);
  }
  [[nodiscard]] bool isKeptEnd(int end) const {
    const MeshGeometry& geometry = *m_placement.meshes[end / 2];
    const std::string name =
        std::to_string(m_mechanism.meshLabel(end / 2)) + (end % 2 == 0 ? ":tail" : ":head");
    const GearMesh& mesh = m_mechanism.gearMeshes[end / 2];
    const bool isFewer = end % 2 == 0 ? mesh.tailTeeth < mesh.headTeeth : mesh.headTeeth < mesh.tailTeeth;
    return (pairKind(geometry.kind).isThreaded && isFewer) ||
           isPinned(m_mechanism.links[end % 2 == 0 ? geometry.tail : geometry.head]) ||
           std::find(m_wish.kept.begin(), m_wish.kept.end(), name) != m_wish.kept.end();
  }

  /// The teeth of a wheel that the basic rack of ISO 53 cuts just without undercut: its straight flank ends
  /// where the wheel's flank begins. 0 where no rack cuts it. In the transverse section, in its modules.
  [[nodiscard]] double fewestUncut(int end, const std::vector<int>& ends) const {
    const MeshGeometry& geometry = *m_placement.meshes[end / 2];
    const PairKind& kind = pairKind(geometry.kind);
    if (!kind.touches || kind.axes != LinePosition::parallel) return 0;
    const double lean = std::cos(end % 2 == 0 ? geometry.tailHelix : geometry.headHelix);
    const double angle = std::atan(std::tan(normalAngle(ends)) / lean);
    const double sine = std::sin(angle);
    const double half = std::numbers::pi / 2;
    const double depth = 1.25 * lean;
    const double thickness = half - backlash(end) / 2;
    // Two corners of the rack's tooth share half a pitch, less the flanks' slope.
    const double space = ((2 * half - thickness) / 2 * std::cos(angle) - depth * sine) / (1 - sine);
    const double corner = std::min(0.38 * lean, std::max(space, 0.0));
    return 2 * (depth - corner * (1 - sine)) / (sine * sine);
  }
  [[nodiscard]] double normalAngle(const std::vector<int>& ends) const {
    double degrees = 20;
    if (m_mechanism.gearDefaults && m_mechanism.gearDefaults->pressureAngle)
      degrees = m_mechanism.gearDefaults->pressureAngle->value();
    for (const int end : ends) {
      const auto& stated = m_mechanism.gearMeshes[end / 2].pressureAngle;
      if (!stated) continue;
      degrees = stated->value();
      break;
    }
    return degrees * std::numbers::pi / 180;
  }
  [[nodiscard]] double backlash(int end) const {
    const GearMesh& mesh = m_mechanism.gearMeshes[end / 2];
    const auto& id = end % 2 == 0 ? mesh.tailWheel : mesh.headWheel;
    const Wheel* const wheel = id ? m_mechanism.find(*id) : nullptr;
    if (wheel != nullptr && wheel->backlash) return wheel->backlash->value();
    const auto& defaults = m_mechanism.gearDefaults;
    return defaults && defaults->backlash ? defaults->backlash->value() : 0.04;
  }

  void setDomains() {
    for (const TeethCertificate::Wheel& wheel : m_claim.wheels) {
      const auto any = [&](const auto& is) { return std::any_of(wheel.ends.begin(), wheel.ends.end(), is); };
      const bool isRing = any([&](int end) { return isRingEnd(end); });
      const bool isKept = any([&](int end) { return isKeptEnd(end); });
      std::set<int> counts;
      if (isKept) {
        counts.insert(drawn(wheel.ends.front()));
      } else if (m_wish.stock.empty()) {
        for (int teeth = m_wish.fewest; teeth <= (isRing ? m_wish.mostRing : m_wish.most); ++teeth)
          counts.insert(teeth);
      } else {
        for (const int teeth : m_wish.stock)
          if (teeth >= m_wish.fewest && teeth <= (isRing ? m_wish.mostRing : m_wish.most))
            counts.insert(teeth);
      }
      m_domains.emplace_back(counts.begin(), counts.end());
      m_isKept.push_back(isKept ? 1 : 0);
      double fewest = 0;
      if (!isKept && !isRing)
        for (const int end : wheel.ends) fewest = std::max(fewest, fewestUncut(end, wheel.ends));
      m_fewestUncut.push_back(fewest);
    }
  }

  /// Meshes between the same two axes, which have one centre distance.
  void setDistances() {
    std::vector<int> train(m_claim.wheels.size());
    std::iota(train.begin(), train.end(), 0);
    for (bool isChanged = !m_wish.hasOneModule; isChanged;) {
      isChanged = false;
      for (MeshOrdinal mesh = 0; mesh < m_mechanism.c(); ++mesh) {
        int& one = train[static_cast<std::size_t>(wheelAt(2 * mesh))];
        int& other = train[static_cast<std::size_t>(wheelAt(2 * mesh + 1))];
        if (one == other) continue;
        one = other = std::min(one, other);
        isChanged = true;
      }
    }
    std::map<std::vector<int>, std::vector<int>> meshes;
    for (MeshOrdinal mesh = 0; mesh < m_mechanism.c(); ++mesh) {
      const MeshGeometry& geometry = *m_placement.meshes[mesh];
      if (!hasParallelAxes(geometry.kind)) continue;
      const int module = m_wish.hasOneModule ? 0 : train[static_cast<std::size_t>(wheelAt(2 * mesh))];
      meshes[{std::min<int>(geometry.tailClass, geometry.headClass),
              std::max<int>(geometry.tailClass, geometry.headClass), module}]
          .push_back(mesh);
    }
    m_checksAt.resize(m_claim.order.size());
    std::map<int, int> pinned;  // by module: a mesh between two pinned axes
    for (const auto& [key, of] : meshes) {
      const bool areAxesPinned = isPinnedAxis(key[0]) && isPinnedAxis(key[1]);
      const bool isModulePinned =
          std::any_of(of.begin(), of.end(), [&](int mesh) { return isPinned(m_mechanism.gearMeshes[mesh]); });
      const bool stays = m_wish.keepsDistances || (areAxesPinned && isModulePinned);
      for (std::size_t i = 0; i < of.size(); ++i) {
        for (std::size_t k = 0; k <= i; ++k)
          addCheck({of[i], of[k], k == i && stays ? drawnDistance(of.front()) : 0, 1, 1});
      }
      if (!areAxesPinned) continue;
      const auto [first, isFirst] = pinned.try_emplace(key[2], of.front());
      if (!isFirst)
        addCheck({first->second, of.front(), 0, static_cast<int>(drawnDistance(of.front())),
                  static_cast<int>(drawnDistance(first->second))});
    }
  }
  [[nodiscard]] bool isPinnedAxis(AxisGroupOrdinal axisGroup) const {
    return isPinned(m_mechanism.axes[m_placement.classes->classes[axisGroup].axis]);
  }
  [[nodiscard]] std::int64_t drawnDistance(MeshOrdinal mesh) const {
    const std::int64_t tail = drawn(2 * mesh), head = drawn(2 * mesh + 1);
    return hasRing(m_placement.meshes[mesh]->kind) ? std::abs(tail - head) : tail + head;
  }
  /// N_tail + N_head, or those of the ring less those of the pinion.
  [[nodiscard]] std::int64_t distance(MeshOrdinal mesh) const {
    const std::int64_t tail = at(wheelAt(2 * mesh)), head = at(wheelAt(2 * mesh + 1));
    if (!hasRing(m_placement.meshes[mesh]->kind)) return tail + head;
    return isRingEnd(2 * mesh) ? tail - head : head - tail;
  }
  [[nodiscard]] int at(int wheel) const { return m_teeth[static_cast<std::size_t>(wheel)]; }

  /// Two meshes whose distances have to agree; one with itself: it has to be above 0, and `stays` if that is
  /// not 0.
  struct DistanceCheck {
    int one = 0, other = 0;
    std::int64_t stays = 0;
    int factor = 1, otherFactor = 1;
  };
  void addCheck(const DistanceCheck& check) {
    std::size_t last = 0;
    for (const int end : {2 * check.one, 2 * check.one + 1, 2 * check.other, 2 * check.other + 1}) {
      const auto place = std::find(m_claim.order.begin(), m_claim.order.end(), wheelAt(end));
      last = std::max(last, static_cast<std::size_t>(place - m_claim.order.begin()));
    }
    m_checksAt[last].push_back(check);
  }
  [[nodiscard]] bool passes(const DistanceCheck& check) const {
    const std::int64_t one = distance(check.one);
    if (check.one == check.other) {
      if (one < 1) return false;
      return check.stays == 0 || std::abs(one - check.stays) <= m_wish.slack;
    }
    const bool isProportional = check.factor != 1 || check.otherFactor != 1;
    const std::int64_t apart = check.factor * one - check.otherFactor * distance(check.other);
    return isProportional ? apart == 0 : std::abs(apart) <= m_wish.slack;
  }

  void visit(std::size_t place) {
    if (place == m_claim.order.size()) return judge();
    if (m_stop.stop_requested()) m_stopped = true;
    const auto wheel = static_cast<std::size_t>(m_claim.order[place]);
    const int copies = m_claim.wheels[wheel].copies;
    const bool takes = m_wish.usesStockOnce && m_isKept[wheel] == 0;
    for (const int teeth : m_domains[wheel]) {
      if (m_stopped) return;
      if (takes && m_stock[teeth] < copies) continue;
      m_teeth[wheel] = teeth;
      const std::vector<DistanceCheck>& checks = m_checksAt[place];
      if (!std::all_of(checks.begin(), checks.end(), [&](const DistanceCheck& each) { return passes(each); }))
        continue;
      if (takes) m_stock[teeth] -= copies;
      visit(place + 1);
      if (takes) m_stock[teeth] += copies;
    }
  }

  [[nodiscard]] int branchOf() const { return m_claim.first < 0 ? 0 : at(m_claim.first); }

  void count(std::size_t stage) {
    ++m_total[stage];
    ++m_branches[branchOf()][stage];
  }

  void judge() {
    count(0);
    std::vector<std::optional<Long>>& values = m_values;
    values.clear();
    for (const TeethCertificate::Ratio& ratio : m_claim.ratios) {
      for (const auto* terms : {&ratio.numerator, &ratio.denominator}) {
        values.push_back(shortValue(*terms, m_teeth));
        if (values.back() ? *values.back() == 0 : longValue(*terms, m_teeth).isZero()) return;
      }
    }
    count(1);
    for (const CheckedPlanets& set : m_planets) {
      const int planets = m_wish.planets > 0 ? m_wish.planets : set.drawn();
      if ((planets > 1 || set.hasPlanetsInMesh()) && !set.clears(m_teeth, planets)) return;
    }
    count(2);
    for (const CheckedPlanets& set : m_planets) {
      const int planets = m_wish.planets > 0 ? m_wish.planets : set.drawn();
      if (planets > 1 && !set.assembles(m_teeth, planets)) return;
    }
    count(3);
    if (m_wish.onlyHunting) {
      for (std::size_t end = 0; end < m_wheelOfEnd.size(); end += 2) {
        const int tail = m_wheelOfEnd[end], head = m_wheelOfEnd[end + 1];
        const bool areKept =
            m_isKept[static_cast<std::size_t>(tail)] != 0 && m_isKept[static_cast<std::size_t>(head)] != 0;
        if (!areKept && std::gcd(at(tail), at(head)) != 1) return;
      }
    }
    count(4);
    if (!m_wish.allowsUndercut) {
      for (std::size_t wheel = 0; wheel < m_teeth.size(); ++wheel)
        if (m_teeth[wheel] < m_fewestUncut[wheel] - 1e-9) return;
    }
    count(5);
    for (std::size_t i = 0; i < m_claim.ratios.size(); ++i) {
      const RatioBounds& bounds = m_wish.ratios[i].bounds;
      const auto sign = [&](const Rational& bound) {
        return compared(values[2 * i], values[2 * i + 1], bound, m_claim.ratios[i], m_teeth);
      };
      if (sign(bounds.low) < 0) return;
      const int high = sign(bounds.high);
      if (high > 0 || (high == 0 && !bounds.includesHigh)) return;
    }
    count(6);
    remember();
  }

  /// Keeps what is as good as the worst of the listed choices, or better.
  void remember() {
    if (m_claim.choices.empty()) return;
    Rational error = 0;
    for (std::size_t i = 0; i < m_claim.ratios.size(); ++i) {
      const RatioBounds& bounds = m_wish.ratios[i].bounds;
      const Rational ratio =
          longValue(m_claim.ratios[i].numerator, m_teeth) / longValue(m_claim.ratios[i].denominator, m_teeth);
      error = std::max(error, ((ratio - bounds.wanted) / bounds.wanted).abs());
    }
    if (error <= m_worst) m_near.emplace_back(std::move(error), m_teeth);
  }

  void compareAll() {
    if (m_total != m_claim.counts)
      fault(translated("The counts are %1 choices and %2 within the bounds, not %3 and %4.",
                       {std::to_string(m_total[0]), std::to_string(m_total[6]),
                        std::to_string(m_claim.counts[0]), std::to_string(m_claim.counts[6])}));
    std::map<int, TeethCertificate::Counts> claimed;
    for (const TeethCertificate::Branch& branch : m_claim.branches)
      if (branch.counts[0] > 0) claimed[branch.teeth] = branch.counts;
    // A wheel that is inverted has one branch for all its teeth.
    const bool isWhole = claimed.size() == 1 && m_claim.branches.size() == 1;
    if (isWhole ? claimed.begin()->second != m_total : claimed != m_branches)
      fault(translated("The counts of the branches are not those of the choices."));
    const auto rank = [](const std::pair<Rational, std::vector<int>>& one,
                         const std::pair<Rational, std::vector<int>>& other) {
      if (one.first != other.first) return one.first < other.first;
      const int a = *std::max_element(one.second.begin(), one.second.end());
      const int b = *std::max_element(other.second.begin(), other.second.end());
      return a != b ? a < b : one.second < other.second;
    };
    std::sort(m_near.begin(), m_near.end(), rank);
    if (m_claim.choices.size() > m_near.size() ||
        (m_claim.choices.empty() && m_total[6] > 0 && m_claim.counts[6] == 0))
      fault(translated("Choices are listed that there are not."));
    for (std::size_t i = 0; i < std::min(m_claim.choices.size(), m_near.size()); ++i) compareChoice(i);
  }

  void compareChoice(std::size_t i) {
    const TeethCertificate::Choice& choice = m_claim.choices[i];
    bool isRight = choice.teeth == m_near[i].second && choice.ratios.size() == m_claim.ratios.size() &&
                   choice.errors.size() == m_claim.ratios.size();
    for (std::size_t k = 0; k < m_claim.ratios.size() && isRight; ++k) {
      const RatioBounds& bounds = m_wish.ratios[k].bounds;
      const Rational ratio = longValue(m_claim.ratios[k].numerator, choice.teeth) /
                             longValue(m_claim.ratios[k].denominator, choice.teeth);
      isRight =
          choice.ratios[k] == ratio && choice.errors[k] == (ratio - bounds.wanted) / bounds.wanted.abs();
    }
    if (!isRight) fault(translated("Choice %1 is not the one that follows.", {std::to_string(i + 1)}));
  }

  const TeethCertificate& m_claim;
  const TeethWish& m_wish;
  const Mechanism& m_mechanism;
  const Placement& m_placement;
  std::stop_token m_stop;
  TeethVerdict m_verdict;
  std::vector<int> m_wheelOfEnd;
  std::vector<std::vector<int>> m_domains;
  std::vector<char> m_isKept;
  std::vector<double> m_fewestUncut;
  std::vector<std::vector<DistanceCheck>> m_checksAt;
  std::vector<CheckedPlanets> m_planets;
  std::map<int, int> m_stock;
  std::vector<int> m_teeth;
  std::vector<std::optional<Long>> m_values;
  TeethCertificate::Counts m_total{};
  std::map<int, TeethCertificate::Counts> m_branches;
  Rational m_worst;
  std::vector<std::pair<Rational, std::vector<int>>> m_near;
  bool m_stopped = false;
};

}  // namespace

Expected<TeethVerdict> checkTeeth(std::string_view certificate, const std::stop_token& stop) {
  const auto read = readTeethCertificate(certificate);
  if (!read) return read.error();
  Diagnostics errors = treeDiagnostics(read->mechanism);
  const Placement placement = placementOf(read->mechanism);
  append(errors, placement.diagnostics);
  std::erase_if(errors, [](const Diagnostic& each) { return each.severity() != Severity::error; });
  if (!errors.empty()) return errors;
  return TeethChecker(*read, placement, stop).run();
}

std::string verdictJson(const TeethVerdict& verdict) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-teeth-check");
    json.member("version", 1);
    json.member("holds", verdict.holds());
    json.member("complete", verdict.isComplete);
    json.member("tried", verdict.tried);
    json.member("count", verdict.within);
    json.member("choices", static_cast<std::int64_t>(verdict.choices));
    json.key("faults");
    json.beginArray();
    for (const std::string& fault : verdict.faults) json.string(fault);
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

}  // namespace geargraph
