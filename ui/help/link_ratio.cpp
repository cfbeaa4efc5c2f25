#include "ui/help/link_ratio.h"

#include <vector>

#include "core/theory/states/relative_speed.h"

namespace geargraph {
namespace {

/// The speeds of both links about one direction, of one motion.
struct Speeds {
  Rational of, to;
};

/// The rates of all joints while one input turns with 1 rad/s and the others stand.
std::vector<Rational> ratesOf(const ExactSolution& exact, std::size_t input) {
  std::vector<Rational> rates(exact.rates.size());
  rates[static_cast<std::size_t>(exact.inputs[input])] = 1;
  for (std::size_t i = 0; i < exact.outputs.size(); ++i)
    rates[static_cast<std::size_t>(exact.outputs[i])] = exact.matrix[i * exact.inputs.size() + input];
  return rates;
}

/// std::nullopt where the axes are not parallel, or a link turns about several.
std::optional<Speeds> speedsOf(const Placement& placement, const std::vector<Rational>& rates, int of,
                               int to) {
  const std::vector<SpeedAbout> one = absoluteSpeed(placement, rates, of);
  const std::vector<SpeedAbout> other = absoluteSpeed(placement, rates, to);
  if (one.size() > 1 || other.size() > 1) return std::nullopt;
  Speeds speeds;
  if (!one.empty()) speeds.of = one.front().speed;
  if (!other.empty()) speeds.to = other.front().speed;
  if (one.empty() || other.empty()) return speeds;
  const int sign = directionSign(placement, one.front().axisGroup, other.front().axisGroup);
  if (sign == 0) return std::nullopt;
  if (sign < 0) speeds.of = -speeds.of;
  return speeds;
}

/// The directions of the single motions agree where each is parallel to the reference: that of `to`.
std::optional<AxisGroupOrdinal> directionOf(const Placement& placement, const std::vector<Rational>& rates,
                                            int link) {
  const std::vector<SpeedAbout> speed = absoluteSpeed(placement, rates, link);
  return speed.size() == 1 ? std::optional(speed.front().axisGroup) : std::nullopt;
}

}  // namespace

LinkRatio linkRatio(const AnalysisSnapshot& snapshot, int of, int to) {
  const bool isSolved = snapshot.kinematics && snapshot.solved && snapshot.solved->exact;
  if (!isSolved) return {};
  const Placement& placement = snapshot.kinematics->placement();
  const ExactSolution& exact = *snapshot.solved->exact;
  const std::size_t inputs = exact.inputs.size();
  if (exact.matrix.size() == exact.outputs.size() * inputs && inputs > 0) {
    // The same in every motion where the speeds under each input are multiples of the same pair.
    std::vector<Speeds> all;
    std::optional<AxisGroupOrdinal> reference;
    for (std::size_t input = 0; input < inputs; ++input) {
      const std::vector<Rational> rates = ratesOf(exact, input);
      const std::optional<Speeds> speeds = speedsOf(placement, rates, of, to);
      if (!speeds) return {LinkRatio::Kind::notParallel, {}};
      const auto direction = directionOf(placement, rates, speeds->to.isZero() ? of : to);
      if (direction && reference && directionSign(placement, *reference, *direction) == 0)
        return {LinkRatio::Kind::notParallel, {}};
      if (direction && !reference) reference = direction;
      all.push_back(*speeds);
    }
    const Speeds* fixed = nullptr;
    bool isFixed = true;
    for (const Speeds& each : all) {
      if (each.of.isZero() && each.to.isZero()) continue;
      if (fixed == nullptr) fixed = &each;
      isFixed = isFixed && (each.of * fixed->to - each.to * fixed->of).isZero();
    }
    if (fixed == nullptr || (isFixed && fixed->to.isZero())) return {LinkRatio::Kind::still, {}};
    if (isFixed) return {LinkRatio::Kind::exact, fixed->of / fixed->to};
  }
  const std::optional<Speeds> now = speedsOf(placement, exact.rates, of, to);
  if (!now) return {LinkRatio::Kind::notParallel, {}};
  if (now->to.isZero()) return {LinkRatio::Kind::still, {}};
  return {LinkRatio::Kind::now, now->of / now->to};
}

}  // namespace geargraph
