#include "core/presentation/meshfile/link_scene.h"

#include <cmath>
#include <numbers>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/meshfile/turn_keys.h"
#include "core/theory/pose/period.h"

namespace geargraph {
namespace {

std::string nameOf(const Link& link, int label) {
  return link.name.empty() ? "link " + std::to_string(label) : link.name;
}

/// Where each link's frame has its origin: on its joint's line; the ground's is the base frame.
Eigen::Vector3d originOf(const LinkSceneSource& source, LinkOrdinal link) {
  if (link == 0) return Eigen::Vector3d::Zero();
  return source.kinematics.line(source.tree.jointToParent(link)).point;
}

/// Whole quarter turns of each joint in one period, by joint; of a stretch or a range, their rates instead.
struct Period {
  std::vector<long long> quarters;
  double seconds = 0;
  std::vector<double> rates = {};
  std::optional<std::pair<double, double>> range = {};
};

MeshFileError tooLong(const Rational& turns) {
  return {
      MeshFileError::Kind::limit,
      translated("The motion repeats only after %1 turns of what turns at 1 rad/s; that is too long for an "
                 "animation.",
                 {turns.toString()})};
}

/// A stretch, or there and back in a range.
std::variant<Period, MeshFileError> boundedOf(const UniformMotion& motion) {
  Period period;
  period.range = motion.range;
  const double ofMotion = motion.range ? 2 * (motion.range->second - motion.range->first) : *motion.stretch;
  period.seconds = motion.range ? motion.seconds.value_or(ofMotion) : ofMotion;
  double keys = 0;
  for (const Rational& rate : motion.rates) {
    period.rates.push_back(rate.toDouble());
    keys += std::abs(period.rates.back()) * ofMotion * 2 / std::numbers::pi + 4;
  }
  if (keys <= static_cast<double>(kMaxKeys)) return period;
  return MeshFileError{MeshFileError::Kind::limit,
                       translated("The motion is too fast for an animation that long.")};
}

/// How the joint turns; no keys where it stands still.
std::vector<RotationKey> keysOf(const LinkSceneSource& source, const Period& period, JointOrdinal joint) {
  const auto place = static_cast<std::size_t>(joint);
  const Eigen::Vector3d axis = source.kinematics.line(joint).direction;
  const int sense = -source.tree.directionToGround(joint);
  const bool turns = place < period.rates.size() && period.rates[place] != 0;
  if (turns && period.range) {
    const auto [from, to] = *period.range;
    auto keys = thereAndBack(axis, Eigen::Quaterniond::Identity(), sense * period.rates[place], from, to);
    for (RotationKey& key : keys) key.seconds *= period.seconds / (2 * (to - from));
    return keys;
  }
  if (turns)
    return turnFor(axis, Eigen::Quaterniond::Identity(), sense * period.rates[place], period.seconds);
  if (place < period.quarters.size() && period.quarters[place] != 0)
    return uniformTurn(axis, Eigen::Quaterniond::Identity(), sense * period.quarters[place], period.seconds);
  return {};
}

std::variant<Period, MeshFileError> periodOf(const UniformMotion& motion) {
  const std::optional<Rational> turns = commonPeriod(motion.rates);
  if (!turns) return Period{std::vector<long long>(motion.rates.size(), 0), 0};
  Period period;
  double keys = 0;
  for (const Rational& rate : motion.rates) {
    const double quarters = 4 * (rate * *turns).toDouble();
    keys += std::abs(quarters) + 1;
    if (!(keys <= static_cast<double>(kMaxKeys))) return tooLong(*turns);
    period.quarters.push_back(std::llround(quarters));  // whole already, and small
  }
  period.seconds = motion.seconds.value_or(2 * std::numbers::pi * turns->toDouble());
  return period;
}

void addLinks(MeshScene& scene, const LinkSceneSource& source, const Period& period,
              std::vector<std::size_t>& places) {
  places.assign(source.mechanism.links.size(), 0);
  for (const LinkOrdinal link : source.tree.preorder()) {
    const auto position = static_cast<std::size_t>(link);
    MeshNode node;
    node.name = nameOf(source.mechanism.links[position], link);
    node.pose.translation() = originOf(source, link);
    if (link != 0) {
      const int parent = source.tree.parent(link);
      const JointOrdinal joint = source.tree.jointToParent(link);
      node.parent = places[static_cast<std::size_t>(parent)];
      node.pose.translation() -= originOf(source, parent);
      node.keys = keysOf(source, period, joint);
    }
    places[position] = scene.nodes.size();
    scene.nodes.push_back(std::move(node));
  }
}

}  // namespace

std::variant<MeshScene, MeshFileError> linkScene(const LinkSceneSource& source,
                                                 const std::optional<UniformMotion>& motion) {
  Period period;
  if (motion) {
    GEARGRAPH_REQUIRE(static_cast<int>(motion->rates.size()) == source.kinematics.jointCount());
    auto found = motion->stretch || motion->range ? boundedOf(*motion) : periodOf(*motion);
    if (const auto* error = std::get_if<MeshFileError>(&found)) return *error;
    period = std::get<Period>(std::move(found));
  }
  MeshScene scene;
  scene.name = source.mechanism.name;
  scene.unit = source.mechanism.unit;
  for (std::size_t i = 0; i < source.mechanism.links.size(); ++i) {
    const int label = static_cast<int>(i);
    scene.materials.push_back(
        {nameOf(source.mechanism.links[i], label), source.colourOfLink(source.mechanism.colorNumber(label))});
  }
  std::vector<std::size_t> places;
  addLinks(scene, source, period, places);
  for (const LinkPart& part : source.parts) {
    const auto link = static_cast<std::size_t>(part.link);
    MeshNode node{part.name, places[link], part.pose, part.solid, link, {}};
    node.pose.translation() -= originOf(source, part.link);
    scene.nodes.push_back(std::move(node));
  }
  return scene;
}

}  // namespace geargraph
