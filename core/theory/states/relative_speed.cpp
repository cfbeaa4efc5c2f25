#include "core/theory/states/relative_speed.h"

#include <algorithm>

#include "core/mechanism/placement/mesh_word.h"
#include "core/mechanism/placement/tolerance.h"

namespace geargraph {

namespace {

template <class Value>
std::vector<SpeedAboutOf<Value>> summedSpeeds(const Placement& placement, std::span<const Value> rates,
                                              LinkOrdinal link) {
  const JointTree& tree = *placement.tree;
  std::vector<SpeedAboutOf<Value>> speeds;
  while (link != 0) {
    const auto joint = static_cast<std::size_t>(tree.joint[link]);
    const LinkOrdinal parent = tree.parent[link];
    const int at = placement.classes->classOf[joint];
    int sense = (tree.joints[joint].tail == parent ? 1 : -1) * placement.classes->orientationSign[joint];
    auto known = speeds.begin();
    while (known != speeds.end() && directionSign(placement, known->axisGroup, at) == 0) ++known;
    if (known == speeds.end()) {
      known = speeds.insert(known, SpeedAboutOf<Value>{at, Rational(0)});
    } else {
      sense *= directionSign(placement, known->axisGroup, at);
    }
    known->speed += Value(Rational(sense)) * rates[joint];
    link = parent;
  }
  std::erase_if(speeds, [](const SpeedAboutOf<Value>& about) { return about.speed.isZero(); });
  return speeds;
}

}  // namespace

int directionSign(const Placement& placement, AxisGroupOrdinal oneClass, AxisGroupOrdinal otherClass) {
  const auto& classes = placement.classes->classes;
  if (classes[oneClass].kind != classes[otherClass].kind) return 0;
  const Vector3& one = placement.lineOfClass(oneClass).direction;
  const Vector3& other = placement.lineOfClass(otherClass).direction;
  if (length(cross(one, other)) >= kSameLine) return 0;
  return dot(one, other) < 0 ? -1 : 1;
}

std::vector<SpeedAbout> absoluteSpeed(const Placement& placement, std::span<const Rational> rates,
                                      LinkOrdinal link) {
  return summedSpeeds(placement, rates, link);
}

std::vector<SpeedAboutOf<PiNumber>> absoluteSpeed(const Placement& placement, std::span<const PiNumber> rates,
                                                  LinkOrdinal link) {
  return summedSpeeds(placement, rates, link);
}

RelativeSpeed RelativeSpeed::between(const Placement& placement, LinkOrdinal from, LinkOrdinal to) {
  const AxisGroups& classes = *placement.classes;
  AxisGroupPath path;
  path.walk(classes, from, to);
  RelativeSpeed speed;
  int last = -1;  // the part of the stretch before
  LinkOrdinal entry = from;
  for (std::size_t i = 0; i < path.classes().size(); ++i) {
    const AxisGroupOrdinal at = path.classes()[i];
    const LinkOrdinal exit = i + 1 < path.classes().size() ? path.change(i) : to;
    int sign = 1;
    auto part = std::find_if(speed.parts.begin(), speed.parts.end(), [&](const Part& known) {
      return (sign = directionSign(placement, known.axisGroup, at)) != 0;
    });
    if (part == speed.parts.end()) {
      sign = 1;
      part = speed.parts.insert(part, Part{at, {}});
    }
    const LinkOrdinal rootLink = classes.classes[at].rootLink;
    if (exit != rootLink) part->terms.push_back({exit, sign});
    if (entry != rootLink) part->terms.push_back({entry, -sign});
    const int index = static_cast<int>(part - speed.parts.begin());
    if (index != last) ++speed.stretches;
    last = index;
    entry = exit;
  }
  return speed;
}

}  // namespace geargraph
