#include "core/scene/frame_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/render/primitives.h"

namespace geargraph {
namespace {

constexpr double kShaftOfWheel = 0.2;  // thinnest shaft by smallest pitch radius
constexpr double kThicker = 0.32;      // each tube is thicker than the one in it by this part of the thinnest
constexpr double kCollinearPenalty =
    1.5;  // a bar beside the axis is rather taken than one through what turns there
constexpr double kEndInRadii = 1.6;  // shafts stand out by so many radii
constexpr double kFloorInRadii = 5;  // below the lowest part

struct Span {
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();
  void add(double along) {
    from = std::min(from, along);
    to = std::max(to, along);
  }
  [[nodiscard]] double length() const { return to - from; }
};

struct Bar {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
};

/// The way from a segment's nearest point to a place.
Eigen::Vector3d nearestOn(const Bar& bar, const Eigen::Vector3d& place) {
  const Eigen::Vector3d along = bar.to - bar.from;
  const double part = along.squaredNorm() > 0 ? (place - bar.from).dot(along) / along.squaredNorm() : 0;
  return bar.from + std::clamp(part, 0.0, 1.0) * along;
}

class FrameBuilder {
 public:
  FrameBuilder(const Mechanism& mechanism, const Placement& placement, std::span<const WheelPart> wheels)
      : m_mechanism(mechanism), m_placement(placement), m_tree(*placement.tree), m_wheels(wheels) {}

  FrameParts build() {
    findBearings();
    findScale();
    findSpans();
    connectAxes();
    standOnTheFloor();
    rankTubes();
    makeSolids();
    return std::move(m_parts);
  }

 private:
  using LinkAndClass = std::pair<int, int>;

  [[nodiscard]] int classOf(int joint) const {
    return m_placement.classes->classOf[static_cast<std::size_t>(joint)];
  }
  [[nodiscard]] int topOf(int axisClass) const {
    return m_placement.classes->classes[static_cast<std::size_t>(axisClass)].top;
  }
  [[nodiscard]] ClassLine line(int axisClass) const { return lineOf(m_placement, axisClass); }
  [[nodiscard]] int parentOf(int joint) const {
    return m_tree.parent[static_cast<std::size_t>(m_tree.child[static_cast<std::size_t>(joint)])];
  }

  void findBearings();
  void findScale();
  void findSpans();
  void connectAxes();
  void connect(int link, int ownClass, std::vector<std::pair<int, Eigen::Vector3d>> targets);
  void standOnTheFloor();
  void rankTubes();
  void makeSolids();
  [[nodiscard]] Solid barSolid(const Bar& bar) const;

  const Mechanism& m_mechanism;
  const Placement& m_placement;
  const JointTree& m_tree;
  std::span<const WheelPart> m_wheels;
  FrameParts m_parts;
  std::map<LinkAndClass, Span> m_spans;
  std::map<LinkAndClass, double> m_radii;
  std::map<int, std::vector<Bar>> m_bars;  ///< by link
};

void FrameBuilder::findBearings() {
  for (std::size_t joint = 0; joint < m_tree.joints.size(); ++joint) {
    const AxisLine& axis = m_placement.axes[static_cast<std::size_t>(m_tree.axisOf[joint])];
    const double offset = m_mechanism.turningJoints[joint].offset.value();
    m_parts.bearings.push_back(vectorOf(axis.point) + offset * vectorOf(axis.direction));
  }
}

void FrameBuilder::findScale() {
  double smallest = std::numeric_limits<double>::infinity();
  for (const WheelPart& wheel : m_wheels) smallest = std::min(smallest, pitchRadius(wheel.spec));
  if (std::isinf(smallest)) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& bearing : m_parts.bearings) box.extend(bearing);
    const double size = box.isEmpty() ? 0 : box.diagonal().norm();
    smallest = size > 0 ? 0.2 * size : 20;
  }
  m_parts.shaftRadius = kShaftOfWheel * smallest;
}

void FrameBuilder::findSpans() {
  const auto cover = [this](int link, int axisClass, double from, double to) {
    for (const int holder : {link, topOf(axisClass)}) {
      Span& span = m_spans[{holder, axisClass}];
      span.add(from);
      span.add(to);
    }
  };
  for (std::size_t joint = 0; joint < m_tree.joints.size(); ++joint) {
    const int axisClass = classOf(static_cast<int>(joint));
    const double along = line(axisClass).along(m_parts.bearings[joint]);
    const double half = m_parts.shaftRadius;
    for (const int link : {m_tree.joints[joint].tail, m_tree.joints[joint].head}) {
      cover(link, axisClass, along - half, along + half);
    }
  }
  for (const WheelPart& wheel : m_wheels) cover(wheel.link, wheel.axisClass, wheel.from, wheel.to);
}

// Farther axes first: their arms are where nearer ones may be held.
void FrameBuilder::connectAxes() {
  std::map<int, std::vector<std::pair<int, Eigen::Vector3d>>> carried;  // link: axis class, a bearing on it
  for (std::size_t joint = 0; joint < m_tree.joints.size(); ++joint) {
    const int axisClass = classOf(static_cast<int>(joint)), link = parentOf(static_cast<int>(joint));
    if (link == 0 || axisClass == m_placement.classes->classOfLink(m_tree, link)) continue;
    auto& targets = carried[link];
    const bool known =
        std::any_of(targets.begin(), targets.end(), [&](const auto& t) { return t.first == axisClass; });
    if (!known) targets.emplace_back(axisClass, m_parts.bearings[joint]);
  }
  for (auto& [link, targets] : carried) {
    connect(link, m_placement.classes->classOfLink(m_tree, link), std::move(targets));
  }
}

void FrameBuilder::connect(int link, int ownClass, std::vector<std::pair<int, Eigen::Vector3d>> targets) {
  const ClassLine own = line(ownClass);
  std::stable_sort(targets.begin(), targets.end(), [&](const auto& a, const auto& b) {
    return (a.second - own.foot(a.second)).norm() >
           (b.second - own.foot(b.second)).norm() + m_parts.shaftRadius;
  });
  for (const auto& [axisClass, bearing] : targets) {
    const ClassLine theirs = line(axisClass);
    const auto leadsThere = [&](const Eigen::Vector3d& from) {
      return (from - theirs.foot(from)).norm() < 0.1 * m_parts.shaftRadius;
    };
    const auto cost = [&](const Eigen::Vector3d& from) {
      return (bearing - from).norm() * (leadsThere(from) ? kCollinearPenalty : 1);
    };
    Eigen::Vector3d from = own.foot(bearing);
    bool fromOwn = true;
    for (const Bar& bar : m_bars[link]) {
      const Eigen::Vector3d candidate = nearestOn(bar, bearing);
      if (cost(candidate) >= cost(from)) continue;
      from = candidate;
      fromOwn = false;
    }
    if (fromOwn) m_spans[{link, ownClass}].add(own.along(from));
    if (leadsThere(from)) {
      m_spans[{link, axisClass}].add(theirs.along(from));
    } else {
      m_bars[link].push_back({from, bearing});
    }
  }
}

void FrameBuilder::standOnTheFloor() {
  double floor = std::numeric_limits<double>::infinity();
  for (const auto& [place, span] : m_spans) {
    for (const double along : {span.from, span.to}) floor = std::min(floor, line(place.second).at(along).z());
  }
  for (const WheelPart& wheel : m_wheels) {
    const double across = std::sqrt(std::max(0.0, 1 - std::pow(wheel.pose.linear()(2, 2), 2)));
    floor = std::min(floor, (wheel.pose * wheel.middle()).z() - across * nominalTipRadius(wheel.spec));
  }
  floor -= kFloorInRadii * m_parts.shaftRadius;
  for (auto& [place, span] : m_spans) {
    if (place.first != 0) continue;
    const ClassLine axis = line(place.second);
    if (std::abs(axis.direction.z()) > 0.9) {
      span.add(axis.along(axis.point + (floor - axis.point.z()) / axis.direction.z() * axis.direction));
    } else {
      const Eigen::Vector3d top = axis.at(span.from);
      m_bars[0].push_back({top, {top.x(), top.y(), floor}});
    }
  }
}

void FrameBuilder::rankTubes() {
  std::map<int, std::vector<std::pair<double, int>>> byClass;  // -length, link
  for (const auto& [place, span] : m_spans) byClass[place.second].emplace_back(-span.length(), place.first);
  for (auto& [axisClass, tubes] : byClass) {
    std::sort(tubes.begin(), tubes.end());
    for (std::size_t rank = 0; rank < tubes.size(); ++rank) {
      const double radius = m_parts.shaftRadius * (1 + kThicker * static_cast<double>(rank));
      m_radii[{tubes[rank].second, axisClass}] = radius;
    }
  }
  for (const WheelPart& wheel : m_wheels)
    m_parts.wheelBoreRadius.push_back(m_radii.at({wheel.link, wheel.axisClass}));
}

Solid FrameBuilder::barSolid(const Bar& bar) const {
  const double half = 0.9 * m_parts.shaftRadius;
  const double length = (bar.to - bar.from).norm();
  return moved(boxSolid({-half, -half, -half}, {half, half, length + half}),
               frameAt(bar.from, (bar.to - bar.from) / length));
}

void FrameBuilder::makeSolids() {
  std::map<int, Solid> solids;
  const double end = kEndInRadii * m_parts.shaftRadius;
  for (const auto& [place, span] : m_spans) {
    const auto& [link, axisClass] = place;
    const double standOut = link == topOf(axisClass) ? end : 0.5 * end;
    const ClassLine axis = line(axisClass);
    append(solids[link], cylinderSolid(m_radii.at(place), span.from - standOut, span.to + standOut),
           frameAt(axis.point, axis.direction));
  }
  for (const auto& [link, bars] : m_bars) {
    for (const Bar& bar : bars) {
      if ((bar.to - bar.from).norm() > 1e-9) append(solids[link], barSolid(bar));
    }
  }
  for (auto& [link, solid] : solids) m_parts.links.push_back({link, std::move(solid)});
  for (std::size_t joint = 0; joint < m_tree.joints.size(); ++joint) {
    const int axisClass = classOf(static_cast<int>(joint)), child = m_tree.child[joint];
    const double radius = m_radii.at({child, axisClass}) + 0.45 * m_parts.shaftRadius;
    const double half = 0.8 * m_parts.shaftRadius;
    m_parts.collars.push_back({parentOf(static_cast<int>(joint)), static_cast<int>(joint),
                               moved(cylinderSolid(radius, -half, half),
                                     frameAt(m_parts.bearings[joint], line(axisClass).direction))});
  }
}

}  // namespace

FrameParts frameParts(const Mechanism& mechanism, const Placement& placement,
                      std::span<const WheelPart> wheels) {
  return FrameBuilder(mechanism, placement, wheels).build();
}

}  // namespace geargraph
