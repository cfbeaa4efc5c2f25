#include <algorithm>
#include <cmath>
#include <deque>

#include "core/mechanism/placement/tolerance.h"
#include "core/presentation/schematic/sheet_layout.h"
#include "core/presentation/schematic/wheel_symbol.h"

namespace geargraph {
namespace {

constexpr double kFlat = 1e-4;  ///< rad, relative: axes given in decimals of five digits lie in one plane
constexpr double kSamePlace = 1e-9;  ///< relative to the train: what rounding leaves of no distance

Vector3 narrow(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

/// The part of v at right angles to a unit vector.
Vector3 across(const Vector3& v, const Vector3& direction) {
  return v - dot(v, direction) * direction;
}

/// What lies to the right and what upward on the sheet.
struct Plane {
  Vector3 right{0, 1, 0};
  Vector3 up{0, 0, 1};

  [[nodiscard]] bool holds(const Vector3& v, double size) const {
    return std::abs(dot(v, cross(right, up))) <= kFlat * size;
  }
  [[nodiscard]] CanvasPoint onSheet(const Vector3& v) const { return {dot(v, right), -dot(v, up)}; }

  /// The plane along both vectors, z up where it is not level, else y.
  static Plane along(const Vector3& a, const Vector3& b) {
    const Vector3 normal = unit(cross(a, b));
    Plane plane;
    plane.up = across({0, 0, 1}, normal);
    if (length(plane.up) < 1e-3) plane.up = across({0, 1, 0}, normal);
    plane.up = unit(plane.up);
    plane.right = cross(plane.up, normal);
    const auto most = std::max_element(plane.right.begin(), plane.right.end(),
                                       [](double x, double y) { return std::abs(x) < std::abs(y) - 1e-9; });
    if (*most < 0) plane.right = -1.0 * plane.right;
    return plane;
  }
};

/// Lays one axis after the other into the sheet, each beside or across a neighbour that lies there already.
class Unfolder {
 public:
  Unfolder(SheetLayout& layout, const TrainWheels& train, const Placement& placement)
      : m_layout(layout), m_train(train), m_placement(placement), m_placed(layout.axes.size()) {
    for (const SheetAxis& axis : layout.axes)
      m_size = std::max(m_size, length(axis.base - layout.axes.front().base));
    for (const TrainWheel& wheel : train.wheels) m_size = std::max(m_size, wheel.workingRadius);
  }

  void unfold() {
    const int first = root();
    m_plane = bestPlane(first);
    m_layout.root = first;
    m_layout.right = m_plane.right;
    m_layout.up = m_plane.up;
    SheetAxis& axis = m_layout.axes[first];
    axis.along = unit(m_plane.onSheet(axis.direction));
    axis.up = {axis.along.y, -axis.along.x};
    axis.upInSpace = axis.up.x * m_plane.right + (-axis.up.y) * m_plane.up;
    axis.origin = m_plane.onSheet(axis.base);
    m_placed[first] = true;
    std::deque<int> queue{first};
    for (const bool meshing : {true, false}) spread(queue, meshing);
    for (std::size_t c = 0; c < m_layout.axes.size(); ++c) {
      if (!m_placed[c]) lay(first, static_cast<int>(c));
    }
  }

 private:
  [[nodiscard]] int root() const {
    const auto& classes = m_placement.classes->classes;
    int best = 0;
    int most = -1;
    for (std::size_t c = 0; c < classes.size(); ++c) {
      if (classes[c].rootLink != 0) continue;
      int weight = 0;
      for (const AxisGroups::Class& other : classes) {
        if (other.rootLink != 0 && axisOfLink(m_placement, other.rootLink) == static_cast<int>(c))
          weight += 3;
      }
      for (const int k : m_placement.classes->classOf) weight += k == static_cast<int>(c) ? 1 : 0;
      if (weight > most) {
        most = weight;
        best = static_cast<int>(c);
      }
    }
    return best;
  }

  /// The plane through the first axis in which the most axes lie.
  [[nodiscard]] Plane bestPlane(int first) const {
    const SheetAxis& axis = m_layout.axes[first];
    Plane best =
        Plane::along(axis.direction, std::abs(axis.direction[1]) < 0.9 ? Vector3{0, 1, 0} : Vector3{0, 0, 1});
    int most = -1;
    for (const SheetAxis& other : m_layout.axes) {
      Vector3 side = across(other.direction, axis.direction);
      if (length(side) < kFlat) {
        side = across(other.base - axis.base, axis.direction);
        if (length(side) <= kSamePlace * m_size) continue;
      }
      const Plane plane = Plane::along(axis.direction, side);
      int count = 0;
      for (const SheetAxis& a : m_layout.axes) {
        const Vector3 apart = a.base - axis.base;
        count += plane.holds(a.direction, 1) && plane.holds(apart, reach(apart)) ? 1 : 0;
      }
      if (count <= most) continue;
      most = count;
      best = plane;
    }
    return best;
  }

  /// What the distance of two axes is measured by.
  [[nodiscard]] double reach(const Vector3& apart) const {
    constexpr double kLeast = 0.01;  // of the train, for axes that are near each other
    return length(apart) + kLeast * m_size;
  }

  [[nodiscard]] bool share(int c, int d) const {
    const auto& classes = m_placement.classes->classes;
    if (c >= classes.count() || d >= classes.count()) return false;
    const int rootC = classes[c].rootLink;
    const int rootD = classes[d].rootLink;
    return rootC == rootD || axisOfLink(m_placement, rootD) == c || axisOfLink(m_placement, rootC) == d;
  }

  [[nodiscard]] bool mesh(int c, int d) const {
    return std::any_of(m_train.pairs.begin(), m_train.pairs.end(), [&](const TrainPair& pair) {
      const int a = m_train.wheels[pair.tail].axisGroup;
      const int b = m_train.wheels[pair.head].axisGroup;
      return (a == c && b == d) || (a == d && b == c);
    });
  }

  /// Do wheels on cylinders mesh on these two skew axes? Cones are drawn as those of a bevel pair.
  [[nodiscard]] bool crossMesh(int c, int d) const {
    return std::any_of(m_train.pairs.begin(), m_train.pairs.end(), [&](const TrainPair& pair) {
      const int a = m_train.wheels[pair.tail].axisGroup;
      const int b = m_train.wheels[pair.head].axisGroup;
      return hasSkewAxes(pair.kind) && !pairKind(pair.kind).isOffset &&
             ((a == c && b == d) || (a == d && b == c));
    });
  }

  void spread(std::deque<int> queue, bool meshing) {
    for (std::size_t c = 0; c < m_placed.size(); ++c) {
      if (m_placed[c]) queue.push_back(static_cast<int>(c));
    }
    while (!queue.empty()) {
      const int c = queue.front();
      queue.pop_front();
      for (std::size_t d = 0; d < m_placed.size(); ++d) {
        const int next = static_cast<int>(d);
        if (m_placed[d] || !share(c, next) || (meshing && !mesh(c, next))) continue;
        lay(c, next);
        queue.push_back(next);
      }
    }
  }

  void lay(int from, int axis) {
    SheetAxis& on = m_layout.axes[axis];
    const SheetAxis& by = m_layout.axes[from];
    m_placed[axis] = true;
    on.turned = by.turned;
    if (length(cross(on.direction, by.direction)) < kSameLine) {
      layBeside(by, on);
    } else if (crossMesh(from, axis)) {
      layTurned(by, on);
    } else {
      layAcross(by, on);
    }
  }

  /// Where a direction at right angles to the neighbour points on the sheet: up or down.
  double sideOf(const SheetAxis& by, const Vector3& side, SheetAxis& on) const {
    const double shown = dot(side, by.upInSpace);
    if (std::abs(shown) < 1 - 1e-6) on.turned = true;
    return shown < -1e-6 ? -1 : 1;
  }

  void layBeside(const SheetAxis& by, SheetAxis& on) const {
    const Vector3 apart = across(on.base - by.base, by.direction);
    const double distance = length(apart);
    const bool same = distance <= kSamePlace * m_size;
    const Vector3 side = same ? by.upInSpace : unit(apart);
    const double sense = same ? 1 : sideOf(by, side, on);
    on.origin = by.at(by.spaceCoordinate(on.base), same ? 0 : sense * distance);
    const double way = dot(on.direction, by.direction) > 0 ? 1 : -1;
    on.along = way * by.along;
    on.up = way * by.up;
    on.upInSpace = way * sense * side;
  }

  /// An axis of a crossed pair, turned about the common perpendicular until it lies beside its neighbour: the
  /// two wheels are seen as they touch.
  void layTurned(const SheetAxis& by, SheetAxis& on) const {
    const Vector3 normal = cross(by.direction, on.direction);
    const double square = dot(normal, normal);
    const Vector3 apart = on.base - by.base;
    const double atBy = dot(cross(apart, on.direction), normal) / square;
    const double atOn = dot(cross(apart, by.direction), normal) / square;
    const double away = dot(apart, normal) / std::sqrt(square);
    const Vector3 side = (away < 0 ? -1 / std::sqrt(square) : 1 / std::sqrt(square)) * normal;
    const double sense = sideOf(by, side, on);
    on.turned = true;
    on.along = by.along;
    on.up = by.up;
    on.upInSpace = sense * side;
    on.origin = by.at(atBy, sense * std::abs(away)) - atOn * on.along;
  }

  void layAcross(const SheetAxis& by, SheetAxis& on) const {
    const Vector3 normal = cross(by.direction, on.direction);
    const double square = dot(normal, normal);
    const Vector3 apart = on.base - by.base;
    const double atBy = dot(cross(apart, on.direction), normal) / square;
    const double atOn = dot(cross(apart, by.direction), normal) / square;
    const double cosine = dot(by.direction, on.direction);
    const double sine = std::sqrt(square);
    const Vector3 side = unit(across(on.direction, by.direction));
    if (std::abs(dot(apart, normal)) > kFlat * sine * reach(apart)) on.turned = true;  // skew
    const double sense = sideOf(by, side, on);
    on.along = cosine * by.along + sense * sine * by.up;
    on.up = {on.along.y, -on.along.x};
    on.upInSpace = (-sense * sine) * by.direction + cosine * sense * side;
    on.origin = by.at(atBy, 0) - atOn * on.along;
  }

  double m_size = 0;  ///< of the train: its largest radius or distance from the first axis
  SheetLayout& m_layout;
  const TrainWheels& m_train;
  const Placement& m_placement;
  ByClass<bool> m_placed;
  Plane m_plane;
};

double scaleFor(const SheetLayout& layout, const TrainWheels& train) {
  constexpr double kSheet = 340;
  constexpr double kLeastRadius = 24;
  constexpr double kMax = 1800;
  Extent all{layout.axes.front().origin, 0, 0};
  double least = 1e300;
  for (const TrainWheel& wheel : train.wheels) {
    const SheetAxis& axis = layout.axes[wheel.axisGroup];
    double coordinate = axis.spaceCoordinate(narrow(wheel.origin));
    const double way = dot(narrow(wheel.axis), axis.direction) < 0 ? -1 : 1;
    coordinate += way * wheelSymbol(wheel.spec.kind).away(wheel);
    for (const double height : {-wheel.workingRadius, wheel.workingRadius}) {
      all = all.united({axis.at(coordinate, height), 0, 0});
    }
    least = std::min(least, wheel.workingRadius);
  }
  for (const SheetAxis& axis : layout.axes) all = all.united({axis.origin, 0, 0});
  const double size = std::max({2 * all.halfWidth, 2 * all.halfHeight, 1e-9});
  if (train.wheels.empty()) return std::min(3.0, kSheet / size);
  return std::min(std::max(kSheet / size, kLeastRadius / least), kMax / size);
}

/// Do the pitch lines of a pair lie side by side anywhere?
bool touch(const SheetLayout& layout, const SheetPair& pair) {
  constexpr double kNear = 3 * kBarGap;
  const SheetWheel& a = layout.wheels[pair.tail];
  const SheetWheel& b = layout.wheels[pair.head];
  for (const double up : {1.0, -1.0}) {
    for (const double down : {1.0, -1.0}) {
      const CanvasPoint p = layout.axes[a.axis].at(a.barFrom.x, up * a.barFrom.y);
      const CanvasPoint q = layout.axes[b.axis].at(b.barFrom.x, down * b.barFrom.y);
      const CanvasPoint r = layout.axes[b.axis].at(b.barTo.x, down * b.barTo.y);
      if (distanceToSegment(p, q, r) < kNear || distance(p, q) < kNear) return true;
    }
  }
  return false;
}

}  // namespace

void layUnfolded(SheetLayout& layout, const TrainWheels& train, const Placement& placement) {
  Unfolder(layout, train, placement).unfold();
  layout.scale = scaleFor(layout, train);
  for (SheetAxis& axis : layout.axes) axis.origin = layout.scale * axis.origin;
  for (std::size_t w = 0; w < layout.wheels.size(); ++w) {
    SheetWheel& wheel = layout.wheels[w];
    wheelSymbol(wheel.kind).setBar(wheel, train.wheels[w], layout.axes[wheel.axis], layout.scale);
  }
  for (std::size_t p = 0; p < layout.pairs.size(); ++p)
    layout.pairs[p].apart = touches(train.pairs[p].kind) && !touch(layout, layout.pairs[p]);
}

}  // namespace geargraph
