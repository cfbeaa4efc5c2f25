#include "core/design/gearboxes/set_teeth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/design/synthesis/planetary_set.h"
#include "core/design/synthesis/shifting_sets.h"

namespace geargraph {
namespace {

RavigneauxTeeth ravigneauxOf(const std::vector<SetTeeth>& parts) {
  return {parts[1].sun, parts[0].sun, parts[1].planet, parts[0].planet};
}

/// Double planets between a sun and a ring: the inner ones clear the ring, the outer ones the sun, and
/// neighbouring pairs each other. Lengths in half modules, tips of one module.
bool pairsFit(const SetTeeth& teeth, int pairs) {
  if ((teeth.ring - teeth.sun) % pairs != 0) return false;
  const auto places = doublePlanetPlaces(teeth.sun, teeth.planet, teeth.outer, teeth.ring);
  if (!places) return false;
  if (teeth.sun + 2 * teeth.planet + 4 >= teeth.ring || teeth.ring - 2 * teeth.outer <= teeth.sun + 4)
    return false;
  return pairsClear(*places, teeth.planet, teeth.outer, pairs);
}

double missOf(const std::vector<SetTeeth>& parts, std::span<const double> k) {
  double miss = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
    miss = std::max(miss, std::abs(std::log(parts[i].ring / (parts[i].sun * k[i]))));
  return miss;
}

/// Keeps the first option of each set of ring ratios.
class Options {
 public:
  Options(SetKind kind, std::span<const double> k, double window) : m_kind(kind), m_k(k), m_window(window) {}

  void add(std::vector<SetTeeth> parts) {
    if (missOf(parts, m_k) > m_window) return;
    std::vector<Rational> ratios;
    for (const SetTeeth& part : parts) ratios.push_back(part.k());
    if (m_byRatios.contains(ratios)) return;
    TeethOption option;
    for (int planets = kMinPlanets; planets <= kMaxPlanets; ++planets) {
      if (planetsFit(m_kind, parts, planets)) option.planets.push_back(planets);
    }
    if (option.planets.empty()) return;
    option.parts = std::move(parts);
    m_byRatios.emplace(std::move(ratios), std::move(option));
  }

  std::vector<TeethOption> nearest(std::size_t most) && {
    std::vector<std::pair<double, TeethOption>> sorted;
    for (auto& [ratios, option] : m_byRatios) {
      const double miss = missOf(option.parts, m_k);
      sorted.emplace_back(miss, std::move(option));
    }
    std::sort(sorted.begin(), sorted.end());
    if (sorted.size() > most) sorted.resize(most);
    std::vector<TeethOption> result;
    for (auto& [miss, option] : sorted) result.push_back(std::move(option));
    return result;
  }

 private:
  SetKind m_kind;
  std::span<const double> m_k;
  double m_window;
  std::map<std::vector<Rational>, TeethOption> m_byRatios;
};

/// The whole suns of a ring at which the ring ratio is within the window.
std::pair<int, int> sunsOf(int ring, double k, const SetTeethWish& limits, double window) {
  const int from = static_cast<int>(std::ceil(ring / k * std::exp(-window) - 1e-9));
  const int to = static_cast<int>(std::floor(ring / k * std::exp(window) + 1e-9));
  return {std::max(from, limits.fewest), std::min(to, ring - 1)};
}

/// The planets of a simple set: the sums of its centres differ by at most the slack, the smaller
/// difference and then the smaller planet first.
std::vector<int> planetsOf(int sun, int ring, const SetTeethWish& limits) {
  std::vector<int> result;
  for (int slack = 0; slack <= limits.slack; ++slack) {
    for (const int miss : {-slack, slack}) {
      const int twice = ring - sun + miss;
      if (twice % 2 == 0 && twice / 2 >= limits.fewest) result.push_back(twice / 2);
      if (slack == 0) break;
    }
  }
  return result;
}

}  // namespace

bool planetsFit(SetKind kind, const std::vector<SetTeeth>& parts, int planets) {
  const SetTeeth& first = parts.front();
  switch (kind) {
    case SetKind::simple: {
      const double centre = std::min(first.sun + first.planet, first.ring - first.planet);
      return (first.sun + first.ring) % planets == 0 &&
             centre * std::sin(std::numbers::pi / planets) > first.planet + 2;
    }
    case SetKind::doublePlanet:
      return pairsFit(first, planets);
    case SetKind::ravigneaux:
      return !ravigneauxFault(ravigneauxOf(parts), planets);
  }
  return false;
}

std::vector<TeethOption> teethNear(SetKind kind, std::span<const double> k, const SetTeethWish& limits,
                                   double window, std::size_t most) {
  Options options(kind, k, window);
  for (int ring = 3 * limits.fewest; ring <= limits.mostRing; ++ring) {
    const auto [from, to] = sunsOf(ring, k[0], limits, window);
    for (int sun = from; sun <= to; ++sun) {
      if (kind == SetKind::simple) {
        for (const int planet : planetsOf(sun, ring, limits)) options.add({{sun, planet, 0, ring}});
      } else if (kind == SetKind::doublePlanet) {
        for (int planet = limits.fewest; 2 * planet < ring - sun; ++planet) {
          for (int outer = planet; outer <= planet + 6; ++outer) options.add({{sun, planet, outer, ring}});
        }
      } else if ((ring - sun) % 2 == 0 &&
                 (ring - sun) / 2 >= limits.fewest) {  // no slack: one ring, two suns
        const int longPlanet = (ring - sun) / 2;
        const auto [fromSmall, toSmall] = sunsOf(ring, k[1], limits, window);
        for (int small = fromSmall; small <= std::min(toSmall, sun - 1); ++small) {
          for (int shortPlanet = limits.fewest; shortPlanet <= longPlanet + sun - small; ++shortPlanet)
            options.add({{sun, longPlanet, 0, ring}, {small, shortPlanet, 0, ring}});
        }
      }
    }
  }
  return std::move(options).nearest(most);
}

}  // namespace geargraph
