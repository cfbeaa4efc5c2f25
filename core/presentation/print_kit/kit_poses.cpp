#include "core/presentation/print_kit/kit_poses.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/theory/pose/joint_limits.h"

namespace geargraph {
namespace {

constexpr int kMaxKitPoses = 144;
constexpr int kMinOfTurn = 8;
constexpr int kMaxOfTurn = 24;

}  // namespace

std::vector<KitPose> kitPoses(const Mechanism& mechanism, const ForwardKinematics& kinematics,
                              std::span<const std::vector<Rational>> motions) {
  std::vector<KitPose> poses;
  std::set<std::vector<Rational>> seen;
  for (const std::vector<Rational>& motion : motions) {
    if (!seen.insert(motion).second) continue;
    std::vector<double> rates;
    std::set<double> speeds;
    for (const Rational& rate : motion) {
      rates.push_back(rate.toDouble());
      if (rates.back() != 0) speeds.insert(std::abs(rates.back()));
    }
    const int count = std::clamp(kMaxKitPoses / static_cast<int>(speeds.size() * motions.size() + 1),
                                 kMinOfTurn, kMaxOfTurn);
    const std::vector<double> reference(rates.size(), 0);
    const MotionRange range = motionRange(angleLimits(mechanism), reference, rates);
    for (const double speed : speeds) {
      const double turn = 2 * std::numbers::pi / speed;
      const double from = std::max(-turn / 2, range.from), to = std::min(turn / 2, range.to);
      for (int i = 0; i < count; ++i) {
        const double time = from + (to - from) * (i + 0.37) / count;  // no part that teeth or planets divide
        std::vector<double> angles;
        for (const double rate : rates) angles.push_back(rate * time);
        poses.push_back(kinematics.poses(angles));
      }
    }
  }
  return poses;
}

}  // namespace geargraph
