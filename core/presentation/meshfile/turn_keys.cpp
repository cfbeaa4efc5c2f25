#include "core/presentation/meshfile/turn_keys.h"

#include <array>
#include <cmath>
#include <numbers>

namespace geargraph {

std::vector<RotationKey> uniformTurn(const Eigen::Vector3d& axis, const Eigen::Quaterniond& rest,
                                     long long quarters, double seconds) {
  // Cosine of half the angle after 0, 1, ... 7 quarter turns; a quaternion returns after two turns.
  const double r = std::sqrt(0.5);
  const std::array<double, 8> cosine{1, r, 0, -r, -1, -r, 0, r};
  const long long count = std::max(std::llabs(quarters), 1LL);
  std::vector<RotationKey> keys;
  keys.reserve(static_cast<std::size_t>(count) + 1);
  for (long long i = 0; i <= count; ++i) {
    const long long turned = (quarters < 0 ? -i : quarters > 0 ? i : 0) & 7;
    const Eigen::Vector3d vector = cosine[(turned + 6) & 7] * axis;  // sine
    const Eigen::Quaterniond turn(cosine[static_cast<std::size_t>(turned)], vector.x(), vector.y(),
                                  vector.z());
    keys.push_back({seconds * static_cast<double>(i) / static_cast<double>(count), turn * rest});
  }
  return keys;
}

std::vector<RotationKey> turnFor(const Eigen::Vector3d& axis, const Eigen::Quaterniond& rest, double rate,
                                 double seconds) {
  const double quarter = std::numbers::pi / 2 / std::abs(rate);  // s
  const auto whole = static_cast<long long>(seconds / quarter);
  std::vector<RotationKey> keys{{0, rest}};
  if (whole > 0)
    keys = uniformTurn(axis, rest, rate < 0 ? -whole : whole, quarter * static_cast<double>(whole));
  if (keys.back().seconds < seconds) {
    const double left = rate * (seconds - keys.back().seconds);
    keys.push_back({seconds, Eigen::AngleAxisd(left, axis) * keys.back().rotation});
  }
  return keys;
}

std::vector<RotationKey> thereAndBack(const Eigen::Vector3d& axis, const Eigen::Quaterniond& rest,
                                      double rate, double from, double to) {
  std::vector<RotationKey> keys{{0, rest}};
  for (const double stretch : {to, from - to, -from}) {  // s of the motion, backwards below 0
    if (stretch == 0) continue;
    const RotationKey start = keys.back();
    const std::vector<RotationKey> more =
        turnFor(axis, start.rotation, stretch < 0 ? -rate : rate, std::abs(stretch));
    for (std::size_t i = 1; i < more.size(); ++i)
      keys.push_back({start.seconds + more[i].seconds, more[i].rotation});
  }
  keys.back().rotation = rest;
  return keys;
}

}  // namespace geargraph
