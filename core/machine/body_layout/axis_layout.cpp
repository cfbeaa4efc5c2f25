#include "core/machine/body_layout/axis_layout.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/machine/solids/gear_body.h"
#include "core/machine/train/train_wheels.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

/// The module in the middle of all: an edit of one wheel seldom changes it, so that the others keep their
/// bores.
double middleModule(const GearTrain& train) {
  if (train.gears.empty()) return kDefaultModule;
  std::vector<double> modules;
  for (const TrainGear& gear : train.gears) modules.push_back(toothSize(gear.spec));
  const auto middle = modules.begin() + static_cast<std::ptrdiff_t>(modules.size() / 2);
  std::nth_element(modules.begin(), middle, modules.end());
  return *middle;
}

void addWheels(const GearTrain& train, std::vector<AxisLayout>& layouts) {
  for (const TrainGear& gear : train.gears) {
    AxisLayout& layout = layouts[static_cast<std::size_t>(gear.axisGroup)];
    const AxialSpan span = axialSpan(gear.spec);
    const double sense = gear.pose.linear().col(2).dot(layout.direction) < 0 ? -1 : 1;
    const double origin = layout.coordinate(gear.pose.translation());
    const double a = origin + sense * span.low;
    const double b = origin + sense * span.high;
    layout.wheels.push_back({std::min(a, b), std::max(a, b), gear.link});
    layout.occupied.push_back(layout.wheels.back());
  }
}

/// Where classes that share a link cross, nothing can stand on either; and bearings go to the other end.
void addIntersections(const Placement& placement, std::vector<AxisLayout>& layouts,
                      const std::stop_token& stop) {
  const AxisGroups& classes = *placement.classes;
  const auto rootOf = [&](std::size_t c) { return classes.classes[c].rootLink; };
  std::vector<std::vector<std::size_t>> heldBy(placement.tree->joint.size());  // classes by their root link
  std::vector<std::vector<std::size_t>> above(layouts.size());  // whose root link turns about this one
  for (std::size_t c = 0; c < layouts.size(); ++c) {
    heldBy[static_cast<std::size_t>(rootOf(c))].push_back(c);
    const AxisGroupOrdinal home = classes.classOfLink(rootOf(c));
    if (home >= 0) above[static_cast<std::size_t>(home)].push_back(c);
  }
  for (std::size_t c = 0; c < layouts.size() && !stop.stop_requested(); ++c) {
    AxisLayout& layout = layouts[c];
    double pull = 0;
    std::vector<std::size_t> related = above[c];
    const std::vector<std::size_t>& beside = heldBy[static_cast<std::size_t>(rootOf(c))];
    related.insert(related.end(), beside.begin(), beside.end());
    const AxisGroupOrdinal home = classes.classOfLink(rootOf(c));
    if (home >= 0) related.push_back(static_cast<std::size_t>(home));
    std::sort(related.begin(), related.end());
    related.erase(std::unique(related.begin(), related.end()), related.end());
    for (const std::size_t d : related) {
      if (d == c) continue;
      const Vector3d across = layout.direction.cross(layouts[d].direction);
      if (across.norm() < 1e-6) continue;
      const Vector3d apart = layouts[d].point - layout.point;
      if (std::abs(apart.dot(across)) > layout.module * across.norm()) continue;
      const double at = apart.cross(layouts[d].direction).dot(across) / across.squaredNorm();
      layout.occupied.push_back({at - 3 * layout.module, at + 3 * layout.module, -1});
      double middle = 0;
      for (const Interval& s : layout.wheels) {
        middle += (s.low + s.high) / 2 / static_cast<double>(layout.wheels.size());
      }
      pull += at - middle;
    }
    layout.bearingSide = pull < -kSameLevel * layout.module ? 1 : -1;
  }
}

}  // namespace

bool AxisLayout::isFree(double low, double high) const {
  return std::none_of(occupied.begin(), occupied.end(),
                      [&](const Interval& s) { return overlap(low, high, s.low, s.high); });
}

std::vector<double> AxisLayout::slotCandidates() const {
  std::vector<double> candidates;
  for (const Interval& s : occupied) {
    candidates.push_back(s.high + gap() + width() / 2);
    candidates.push_back(s.low - gap() - width() / 2);
  }
  if (candidates.empty()) candidates.push_back(0);
  return candidates;
}

double AxisLayout::freeSlot(double wanted) const {
  if (slotIsFree(wanted)) return wanted;
  double best = outerSlot();
  for (const double middle : slotCandidates()) {
    if (slotIsFree(middle) && std::abs(middle - wanted) < std::abs(best - wanted) - kSameLevel * module)
      best = middle;
  }
  return best;
}

double AxisLayout::outerSlot() const {
  double outer = 0;
  bool first = true;
  for (const double middle : slotCandidates()) {
    if (first || isBelow(bearingSide * outer, bearingSide * middle)) outer = middle;
    first = false;
  }
  return outer;
}

std::optional<Interval> AxisLayout::wheelsOf(LinkOrdinal link) const {
  std::optional<Interval> span;
  for (const Interval& s : wheels) {
    if (s.link != link) continue;
    if (!span) span = s;
    span->low = std::min(span->low, s.low);
    span->high = std::max(span->high, s.high);
  }
  return span;
}

bool AxisLayout::nests(const Bearing& bearing, double at) const {
  const auto own = wheelsOf(bearing.child);
  return std::none_of(bearings.begin(), bearings.end(), [&](const Bearing& other) {
    const auto passed = wheelsOf(other.child);
    if (!other.placed || !passed || other.child == bearing.child || other.child == bearing.parent)
      return false;
    const double middle = (passed->low + passed->high) / 2;
    const double side = isBelow(other.at, middle) ? -1 : 1;
    const bool beyond = isBelow(side * middle, side * at);
    const bool through = !own || isBelow(side * (own->low + own->high) / 2, side * middle);
    return beyond && through && isBelow(side * at, side * other.at);
  });
}

bool AxisLayout::emerges(LinkOrdinal link, double level) const {
  const auto own =
      std::find_if(bearings.begin(), bearings.end(), [&](const Bearing& b) { return b.child == link; });
  if (own == bearings.end() || !own->placed) return true;
  return std::none_of(bearings.begin(), bearings.end(), [&](const Bearing& other) {
    const auto passed = wheelsOf(other.child);
    if (!other.placed || !passed || other.child == link) return false;
    const double low = std::min(passed->low, other.at);
    const double high = std::max(passed->high, other.at);
    const bool within = isBelow(low, level) && isBelow(level, high);
    return within && (isBelow(own->at, low) || isBelow(high, own->at));
  });
}

std::vector<AxisLayout> axisLayouts(const Mechanism& mechanism, const Placement& placement,
                                    const GearTrain& train, const std::stop_token& stop) {
  const AxisGroups& classes = *placement.classes;
  const JointTree& tree = *placement.tree;
  ByClass<AxisLayout> layouts(classes.classes.size());
  const double module = middleModule(train);
  for (std::size_t c = 0; c < layouts.size(); ++c) {
    const AxisLine& line = placement.lineOfClass(static_cast<int>(c));
    layouts[c].point = wide(line.point);
    layouts[c].direction = wide(line.direction);
    layouts[c].module = module;
  }
  addWheels(train, layouts);
  addIntersections(placement, layouts, stop);
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    AxisLayout& layout = layouts[classes.classOf[j]];
    const AxisLine& own = placement.axes[tree.axisOf[j]];
    const Vector3d drawn = wide(own.point) + mechanism.turningJoints[j].offset.value() * wide(own.direction);
    const int child = tree.child[j];
    layout.bearings.push_back({static_cast<int>(j), tree.parent[child], child, layout.coordinate(drawn)});
  }
  return layouts;
}

}  // namespace geargraph
