#include "core/presentation/mechanism_scene/joint_stops.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/theory/pose/joint_limits.h"

namespace geargraph {
namespace {

/// The limits of the joints, of which some have any.
class JointStops {
 public:
  JointStops(const Mechanism& mechanism, JointMotion motion)
      : m_limits(angleLimits(mechanism)), m_motion(std::move(motion)), m_rates(m_limits.size()) {
    m_motion.angles(m_motion.speeds, m_rates);
    for (std::size_t i = 0; i < m_limits.size(); ++i) {
      m_labels.push_back(std::to_string(mechanism.jointLabel(static_cast<int>(i))));
      m_units.push_back(slides(mechanism.turningJoints[i]) ? mechanism.unit : std::string());
    }
  }

  [[nodiscard]] SceneRange range(std::span<const double> added) const {
    const std::vector<double> start = jointAngles(added);
    const MotionRange found = motionRange(m_limits, start, m_rates);
    const auto limit = [&](double time, JointOrdinal joint) -> SceneLimit {
      if (joint < 0) return {time, {}};
      const auto j = static_cast<std::size_t>(joint);
      return {time, text(joint, start[j] + m_rates[j] * time)};
    };
    return {limit(found.from, found.fromJoint), limit(found.to, found.toJoint)};
  }

  [[nodiscard]] std::string beyond(std::span<const double> angles) const {
    const std::vector<double> now = jointAngles(angles);
    const std::vector<int> joints = jointsBeyondLimits(m_limits, now);
    if (joints.empty()) return {};
    const auto j = static_cast<std::size_t>(joints.front());
    return text(joints.front(), std::clamp(now[j], m_limits[j].low, m_limits[j].high));
  }

 private:
  [[nodiscard]] std::vector<double> jointAngles(std::span<const double> inputs) const {
    std::vector<double> angles(m_limits.size());
    m_motion.angles(inputs, angles);
    return angles;
  }
  [[nodiscard]] std::string text(JointOrdinal joint, double angle) const {
    const auto j = static_cast<std::size_t>(joint);
    if (!m_units[j].empty())
      return translated("joint %1 at %2 %3", {m_labels[j], readableNumber(angle), m_units[j]});
    return translated("joint %1 at %2°",
                      {m_labels[j], std::to_string(std::lround(angle * 180 / std::numbers::pi))});
  }

  std::vector<AngleLimits> m_limits;
  JointMotion m_motion;
  ByJoint<double> m_rates;  ///< rad/s or lengths a second
  std::vector<std::string> m_labels;
  std::vector<std::string> m_units;  ///< of travels; empty: the joint turns
};

}  // namespace

void addJointStops(MechanismScene& stage, const Mechanism& mechanism, const JointMotion& motion) {
  const auto& joints = mechanism.turningJoints;
  const auto isLimited = [](const TurningJoint& joint) { return joint.limits.any(); };
  if (std::none_of(joints.begin(), joints.end(), isLimited)) return;
  const auto stops = std::make_shared<const JointStops>(mechanism, motion);
  stage.range = [stops](std::span<const double> added) { return stops->range(added); };
  stage.beyondLimits = [stops](std::span<const double> angles) { return stops->beyond(angles); };
}

}  // namespace geargraph
