#include "core/design/synthesis/set_search.h"

#include <array>
#include <utility>

namespace geargraph {
namespace {

/// Within 2 % there are mostly enough; the last one is every ratio of the wanted sign.
RatioBounds boundsAbout(const Rational& wanted, int widening) {
  constexpr int kFar = 1'000'000;
  static const std::array kTolerances = {Rational(1, 1000), Rational(1, 50), Rational(1, 2)};
  if (widening < static_cast<int>(kTolerances.size()))
    return boundsWithin(wanted, kTolerances[static_cast<std::size_t>(widening)]);
  RatioBounds bounds;
  bounds.wanted = wanted;
  const Rational near = wanted / Rational(kFar);
  const Rational far = wanted * Rational(kFar);
  bounds.low = wanted.sign() > 0 ? near : far;
  bounds.high = wanted.sign() > 0 ? far : near;
  return bounds;
}

}  // namespace

std::vector<FoundTeeth> nearestTeeth(const Mechanism& set, TeethWish wish, const Rational& wanted,
                                     const std::function<bool(const std::vector<FoundTeeth>&)>& isEnough) {
  constexpr int kWidenings = 4;
  constexpr std::array<std::size_t, 3> kKept = {400, 6'000, 60'000};  // many teeth may have one ratio
  std::vector<FoundTeeth> best;
  if (wanted.isZero()) return best;
  const PlacedMechanism drawn = set;
  wish.ratios.front().bounds = boundsAbout(wanted, 0);
  auto made = teethProblemOf(drawn, wish);
  if (!made) return best;
  TeethProblem problem = *std::move(made);
  for (int widening = 0; widening < kWidenings; ++widening) {
    problem.ratios.front().bounds = boundsAbout(wanted, widening);
    for (const std::size_t kept : kKept) {
      TeethSearchOptions options;
      options.most = kept;
      best = searchTeeth(problem, options).best;
      if (isEnough(best)) return best;
      if (best.size() < kept) break;  // there are no more within these bounds
    }
  }
  return best;
}

}  // namespace geargraph
