#include <algorithm>
#include <cmath>
#include <deque>
#include <set>
#include <utility>

#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/schematic/radial_system.h"
#include "core/presentation/schematic/sheet_layout.h"
#include "core/presentation/schematic/wheel_symbol.h"

namespace geargraph {
namespace {

Vector3 narrow(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

/// Heights for parallel axes, one neighbour after the other.
class ParallelHeights {
 public:
  /// `givenUp`: by pair, whether its wheels need not touch.
  ParallelHeights(const SheetLayout& layout, const TrainWheels& train, const Placement& placement,
                  const std::vector<bool>& givenUp)
      : m_layout(layout), m_train(train), m_placement(placement), m_height(layout.axes.size()) {
    for (std::size_t p = 0; p < train.pairs.size(); ++p) {
      const int a = train.wheels[train.pairs[p].tail].axisGroup;
      const int b = train.wheels[train.pairs[p].head].axisGroup;
      if (!givenUp[p]) m_meshing.insert({std::min(a, b), std::max(a, b)});
    }
    m_placed.assign(layout.axes.size(), false);
    m_way.assign(layout.axes.size(), 1);
    for (const TrainWheel& wheel : train.wheels) m_along.push_back(plane(narrow(wheel.origin)));
  }

  ByClass<double> heights() {
    const auto classes = m_placement.classes->classes.size();
    if (classes > 0) start(root());
    for (std::size_t c = 0; c < classes; ++c) {
      if (!m_placed[c]) startBeside(static_cast<int>(c));
    }
    for (std::size_t c = classes; c < m_height.size(); ++c) m_height[c] = lonely(static_cast<int>(c));
    return m_height;
  }

  [[nodiscard]] int root() const {
    const auto& classes = m_placement.classes->classes;
    ByClass<int> weight(classes.size());
    for (const auto& c : classes) {
      const int carrier = c.rootLink == 0 ? -1 : axisOfLink(m_placement, c.rootLink);
      if (carrier >= 0) weight[carrier] += 3;
    }
    for (const int c : m_placement.classes->classOf) ++weight[c];
    int best = -1;
    for (std::size_t c = 0; c < classes.size(); ++c) {
      if (classes[c].rootLink == 0 && (best < 0 || weight[c] > weight[best])) best = static_cast<int>(c);
    }
    return best;
  }

 private:
  [[nodiscard]] double plane(const Vector3& p) const { return m_layout.axes.front().spaceCoordinate(p); }

  [[nodiscard]] double trueDistance(int a, int b) const {
    const Vector3 apart = m_layout.axes[b].base - m_layout.axes[a].base;
    return length(cross(m_layout.axes.front().direction, apart));
  }

  void start(int first) {
    m_placed[first] = true;
    std::deque<int> queue{first};
    while (!queue.empty()) {
      const int c = queue.front();
      queue.pop_front();
      for (const TrainPair& pair : m_train.pairs) {
        const int a = m_train.wheels[pair.tail].axisGroup;
        const int b = m_train.wheels[pair.head].axisGroup;
        const int next = a == c ? b : a;
        if ((a != c && b != c) || m_placed[next]) continue;
        place(c, next, pair.distance);
        queue.push_back(next);
      }
      for (std::size_t d = 0; d < m_placement.classes->classes.size(); ++d) {
        const int rootLink = m_placement.classes->classes[d].rootLink;
        if (m_placed[d] || rootLink == 0 || axisOfLink(m_placement, rootLink) != c ||
            meshes(static_cast<int>(d)))
          continue;
        place(c, static_cast<int>(d), trueDistance(c, static_cast<int>(d)));
        queue.push_back(static_cast<int>(d));
      }
    }
  }

  [[nodiscard]] bool meshes(int axis) const {
    return std::any_of(m_train.wheels.begin(), m_train.wheels.end(),
                       [&](const TrainWheel& wheel) { return wheel.axisGroup == axis; });
  }

  /// Away from the neighbour in the direction it was placed itself; the other way where that is taken.
  void place(int from, int axis, double distance) {
    const int rootLink = m_placement.classes->classes[axis].rootLink;
    const bool orbits = rootLink != 0 && axisOfLink(m_placement, rootLink) == from;
    const int way = orbits ? 1 : m_way[from];
    for (const int sense : {way, -way}) {
      m_height[axis] = m_height[from] + sense * distance;
      m_way[axis] = sense;
      if (isFree(axis)) break;
      if (sense == -way) {
        m_height[axis] = m_height[from] + way * distance;
        m_way[axis] = way;
      }
    }
    m_placed[axis] = true;
  }

  /// Does any wheel of the axis stand in the room of another? Meshing axes will be moved apart.
  [[nodiscard]] bool isFree(int axis) const {
    for (std::size_t w = 0; w < m_train.wheels.size(); ++w) {
      if (m_train.wheels[w].axisGroup != axis) continue;
      for (std::size_t v = 0; v < m_train.wheels.size(); ++v) {
        const int other = m_train.wheels[v].axisGroup;
        if (other == axis || !m_placed[other]) continue;
        if (m_meshing.contains({std::min(axis, other), std::max(axis, other)})) continue;
        if (overlap(w, v)) return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool overlap(std::size_t w, std::size_t v) const {
    const TrainWheel& a = m_train.wheels[w];
    const TrainWheel& b = m_train.wheels[v];
    if (std::abs(m_along[w] - m_along[v]) > 0.45 * (a.spec.faceWidth + b.spec.faceWidth)) return false;
    const double apart = std::abs(m_height[a.axisGroup] - m_height[b.axisGroup]);
    const double slack = 0.02 * std::min(a.workingRadius, b.workingRadius);
    if (isRing(a.spec) && isRing(b.spec)) return apart < slack;
    if (isRing(a.spec)) return apart + b.workingRadius > a.workingRadius + slack;
    if (isRing(b.spec)) return apart + a.workingRadius > b.workingRadius + slack;
    return apart < a.workingRadius + b.workingRadius - slack;
  }

  /// An axis that no mesh ties to those placed stands above them.
  void startBeside(int axis) {
    double top = 0;
    for (std::size_t c = 0; c < m_height.size(); ++c) {
      if (m_placed[c]) top = std::max(top, m_height[c] + reach(static_cast<int>(c)));
    }
    const int first = root();
    const double wanted = first >= 0 ? trueDistance(first, axis) : 0;
    m_height[axis] = std::max(wanted, top + 1.15 * reach(axis));
    start(axis);
  }

  [[nodiscard]] double reach(int axis) const {
    double most = 0;
    for (const TrainWheel& wheel : m_train.wheels) {
      if (wheel.axisGroup == axis) most = std::max(most, wheel.workingRadius);
    }
    return most > 0 ? most : 5 * m_placement.module.toDouble();
  }

  [[nodiscard]] double lonely(int axis) const {
    const int first = root();
    return first >= 0 ? m_height[first] + trueDistance(first, axis) : trueDistance(0, axis);
  }

  const SheetLayout& m_layout;
  const TrainWheels& m_train;
  const Placement& m_placement;
  std::set<std::pair<int, int>> m_meshing;  ///< axes whose wheels shall touch
  ByClass<double> m_height;
  ByClass<bool> m_placed;
  ByClass<int> m_way;
  std::vector<double> m_along;
};

/// Room for labels and symbols beside the smallest wheel, and a sheet that fits a window.
double scaleFor(const RadialSystem& system) {
  constexpr double kSheetHeight = 260;
  constexpr double kLeastRadius = 20;
  constexpr double kMaxHeight = 1500;
  double low = 0;
  double high = 0;
  double least = 1e300;
  for (const RadialSystem::Wheel& wheel : system.wheels) {
    low = std::min(low, system.heights[wheel.axis] - wheel.radius);
    high = std::max(high, system.heights[wheel.axis] + wheel.radius);
    least = std::min(least, wheel.radius);
  }
  for (const double height : system.heights) {
    low = std::min(low, height);
    high = std::max(high, height);
  }
  const double extent = std::max(high - low, 1e-9);
  if (system.wheels.empty()) return high - low > 0 ? std::min(4.0, kSheetHeight / extent) : 3;
  return std::min(std::max(kSheetHeight / extent, kLeastRadius / least), kMaxHeight / extent);
}

/// Rolls out; axes whose wheels cannot touch after all are placed once more, out of each other's way.
std::pair<RadialSystem, int> settled(const SheetLayout& layout, const TrainWheels& train,
                                     const Placement& placement, const std::stop_token& stop) {
  std::vector<bool> givenUp(train.pairs.size());
  for (std::size_t p = 0; p < givenUp.size(); ++p) givenUp[p] = !touches(train.pairs[p].kind);
  for (;;) {
    ParallelHeights roller(layout, train, placement, givenUp);
    RadialSystem system;
    system.heights = roller.heights();
    for (const TrainWheel& wheel : train.wheels) {
      system.wheels.push_back({wheel.axisGroup, wheel.workingRadius});
    }
    for (std::size_t p = 0; p < train.pairs.size(); ++p) {
      const TrainPair& pair = train.pairs[p];
      system.contacts.push_back({pair.tail, pair.head, hasRing(pair.kind), !givenUp[p]});
    }
    system.settle(stop);
    bool more = false;
    for (std::size_t p = 0; p < givenUp.size(); ++p) {
      if (givenUp[p] || system.contacts[p].kept) continue;
      givenUp[p] = more = true;
    }
    if (!more || stop.stop_requested()) return {system, roller.root()};
  }
}

/// `radius`: of the largest wheel.
void setPlanes(SheetLayout& layout, const std::vector<std::vector<double>>& ofWheels, double radius) {
  for (const auto& planes : ofWheels) layout.planes.insert(layout.planes.end(), planes.begin(), planes.end());
  std::sort(layout.planes.begin(), layout.planes.end());
  const double size = layout.planes.empty() ? 0 : layout.planes.back() - layout.planes.front();
  const auto same = [&](double a, double b) { return std::abs(a - b) <= 1e-6 * (radius + size); };
  layout.planes.erase(std::unique(layout.planes.begin(), layout.planes.end(), same), layout.planes.end());
}

/// The central axis of an epicyclic train is cut in half where everything lies above it.
void cutInHalf(SheetLayout& layout, const Placement& placement, int root) {
  if (root < 0) return;
  const auto& classes = placement.classes->classes;
  const bool central = std::any_of(classes.begin(), classes.end(), [&](const AxisGroups::Class& c) {
    return c.rootLink != 0 && axisOfLink(placement, c.rootLink) == root;
  });
  const double level = layout.axes[root].origin.y;
  const bool alone = std::all_of(layout.axes.begin(), layout.axes.end(),
                                 [&](const SheetAxis& axis) { return axis.origin.y <= level + 1e-9; });
  layout.axes[root].half = central && alone;
}

/// From the root to the first axis that lies beside it; x, else y, where there is none.
Vector3 sideways(const SheetLayout& layout) {
  const SheetAxis& root = layout.axes[layout.root];
  const auto across = [&](const Vector3& v) { return v - dot(v, root.direction) * root.direction; };
  double farthest = 0;
  for (const SheetAxis& axis : layout.axes)
    farthest = std::max(farthest, length(across(axis.base - root.base)));
  for (const SheetAxis& axis : layout.axes) {
    const Vector3 apart = across(axis.base - root.base);
    if (length(apart) > 1e-6 * farthest) return unit(apart);
  }
  const Vector3 x = across({1, 0, 0});
  return unit(length(x) > 0.5 ? x : across({0, 1, 0}));
}

}  // namespace

void layParallel(SheetLayout& layout, const TrainWheels& train, const Placement& placement,
                 const std::stop_token& stop) {
  if (layout.axes.empty()) return;
  const auto [system, root] = settled(layout, train, placement, stop);
  layout.otherRadii = system.changed;
  layout.scale = scaleFor(system);
  const SheetAxis first = layout.axes.front();
  double largest = 0;
  std::vector<double> along;
  std::vector<std::vector<double>> planes;  // by wheel
  for (const TrainWheel& wheel : train.wheels) {
    largest = std::max(largest, wheel.workingRadius);
    along.push_back(first.spaceCoordinate(narrow(wheel.origin)));
    planes.emplace_back();
    for (const double plane : wheel.planes)
      planes.back().push_back(first.spaceCoordinate(narrow(wheel.origin + plane * wheel.axis)));
  }
  setPlanes(layout, planes, largest);
  layout.root = std::max(root, 0);
  layout.right = first.direction;
  layout.up = sideways(layout);
  const double ground = root >= 0 ? system.heights[root] : 0;
  for (std::size_t c = 0; c < layout.axes.size(); ++c) {
    SheetAxis& axis = layout.axes[c];
    axis.base = axis.base + (-first.spaceCoordinate(axis.base)) * first.direction;
    axis.direction = first.direction;
    axis.origin = {0, -(system.heights[c] - ground) * layout.scale};
  }
  for (std::size_t w = 0; w < layout.wheels.size(); ++w) {
    SheetWheel& wheel = layout.wheels[w];
    wheel.space = along[w];
    const auto [low, high] = std::minmax_element(planes[w].begin(), planes[w].end());
    wheel.low = layout.stretched(*low);
    wheel.high = layout.stretched(*high);
    wheel.at = (wheel.low + wheel.high) / 2;
    wheel.radius = system.wheels[w].radius * layout.scale + wheelSymbol(wheel.kind).side * kBarGap;
    wheel.barFrom = {wheel.low - kBarHalf, wheel.radius};
    wheel.barTo = {wheel.high + kBarHalf, wheel.radius};
    wheel.outward = {0, wheel.isRing() ? -1.0 : 1.0};
  }
  for (std::size_t p = 0; p < layout.pairs.size(); ++p)
    layout.pairs[p].apart = touches(train.pairs[p].kind) && !system.contacts[p].kept;
  cutInHalf(layout, placement, root);
}

}  // namespace geargraph
