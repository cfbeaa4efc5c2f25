#include "core/mechanism/placement/bevel_arranger.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace geargraph {
namespace {

constexpr int kMaxArrangerSteps = 60;   // to either side, one by one; then in strides,
constexpr int kMaxStep = 2000;          // to here
constexpr double kAgainst = 1.5;        // a place on the negative half counts as so much farther,
constexpr double kBehindRoot = 100;     // and where the axis begins at the point
constexpr int kLargestSize = 400;       // halves of the module
constexpr int kTurns = 12;              // poses of a carrier that are looked at
constexpr double kMargin = 1;           // modules between wheels
constexpr std::size_t kMaxWheels = 64;  // of larger trains no room is sought

// The wheels' measures as core/gears chooses them where the document says nothing.
constexpr double kMaxFace = 10;  // modules
constexpr double kBelow = 2.45;  // dedendum and body, modules

/// Tips and body of the wheel whose pitch circle of radius r lies at height h above the apex.
DiscHull bevelHull(const Vector3& apex, const Vector3& axis, double r, double h, double module) {
  const double distance = std::hypot(r, h);
  const double face = std::min(distance / 3, kMaxFace * module);
  const double sine = r / distance, cosine = h / distance;
  const double front = (distance - face) / distance;
  const auto disc = [&](double radius, double height) {
    return Disc{apex + height * axis, axis, std::max(radius, 0.0)};
  };
  const double tipRadius = r + module * cosine, tipHeight = h - module * sine;
  const double backRadius = r - kBelow * module * cosine, backHeight = h + kBelow * module * sine;
  return {disc(tipRadius, tipHeight), disc(front * tipRadius, front * tipHeight),
          disc(backRadius, backHeight)};
}

std::pair<int, int> ordered(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

BevelArranger::BevelArranger(const Mechanism& mechanism, const JointTree* tree, const AxisGroups& classes,
                             SpanByMesh<const std::optional<MeshAxisPath>> words)
    : m_mechanism(mechanism),
      m_tree(tree),
      m_classes(classes),
      m_words(words),
      m_lines(mechanism.axes.size()),
      m_sides(words.size(), {1, 1}),
      m_sizes(words.size(), kUsualBevelSize) {
  SideNumbers numbers;
  for (std::size_t m = 0; m < words.size(); ++m) {
    if (!words[m]) continue;
    const auto& [tailClass, headClass, carrier] = *words[m];
    const auto& all = classes.classes;
    const auto tailTop = static_cast<std::size_t>(tailClass), headTop = static_cast<std::size_t>(headClass);
    m_between[ordered(all[tailTop].axis, all[headTop].axis)].push_back(static_cast<int>(m));
    const auto [tail, head] = tree->meshes[m];
    if (all[tailTop].depth <= all[headTop].depth) {
      m_sides[m].first = numbers.side(tailClass, carrier, tail, head);
    } else {
      m_sides[m].second = numbers.side(headClass, carrier, head, tail);
    }
  }
}

const std::vector<int>& BevelArranger::meshesBetween(int from, int to) const {
  return m_between.at(ordered(from, to));
}

void BevelArranger::addPair(Wheels& wheels, MeshOrdinal mesh, int size, const Vector3& apex, const Line& from,
                            const Line& to, AxisOrdinal fromAxis, double module) {
  const auto m = static_cast<std::size_t>(mesh);
  const auto [tailClass, headClass, carrier] = *m_words[m];
  const GearMesh& drawn = m_mechanism.gearMeshes[m];
  const bool tailIsFrom = m_classes.classes[tailClass].axis == fromAxis;
  const Vector3 tailAxis =
      static_cast<double>(m_sides[m].first) * (tailIsFrom ? from.direction : to.direction);
  const Vector3 headAxis =
      static_cast<double>(m_sides[m].second) * (tailIsFrom ? to.direction : from.direction);
  const double own = module * size / kUsualBevelSize;
  const double sine = length(cross(tailAxis, headAxis));
  const Vector3 point =
      (own / (2 * sine)) * (static_cast<double>(drawn.headTeeth) * tailAxis +
                            static_cast<double>(drawn.tailTeeth) * headAxis);  // of the pitch circles
  const auto [tail, head] = m_tree->meshes[m];
  const int first = static_cast<int>(wheels.size());
  wheels.push_back({tail, tailClass, drawn.tailTeeth,
                    bevelHull(apex, tailAxis, own * drawn.tailTeeth / 2, dot(point, tailAxis), own),
                    first + 1});
  wheels.push_back({head, headClass, drawn.headTeeth,
                    bevelHull(apex, headAxis, own * drawn.headTeeth / 2, dot(point, headAxis), own), first});
}

BevelArranger::Wheels BevelArranger::wheelsBetween(int from, int to, const Vector3& apex, const Line& a,
                                                   const Line& b, double module) {
  Wheels wheels;
  for (const MeshOrdinal mesh : meshesBetween(from, to))
    addPair(wheels, mesh, m_sizes[mesh], apex, a, b, from, module);
  return wheels;
}

/// Pairs about one apex lie one within the other where they would run into each other.
void BevelArranger::setSizes(int from, int to, const Line& a, const Line& b, double module) {
  Wheels standing;
  const auto isSame = [](const Wheel& x, const Wheel& y) {
    return x.link == y.link && x.axisGroup == y.axisGroup &&
           length(x.hull.front().centre - y.hull.front().centre) < 1e-6 * y.hull.front().radius;
  };
  const auto meets = [&](const Wheels& pair) {
    return std::any_of(pair.begin(), pair.end(), [&](const Wheel& wheel) {
      const Wheel& partner = pair[&wheel == &pair.front() ? 1 : 0];
      return std::any_of(standing.begin(), standing.end(), [&](const Wheel& other) {
        return wheel.link != other.link && !isSame(partner, other) &&
               !isSame(wheel, standing[static_cast<std::size_t>(other.partner)]) &&
               areNear(wheel.hull, other.hull, kMargin * module);
      });
    });
  };
  for (const MeshOrdinal mesh : meshesBetween(from, to)) {
    int& size = m_sizes[mesh];
    for (;; size += std::max(1, size / 8)) {
      Wheels pair;
      addPair(pair, mesh, size, {}, a, b, from, module);
      if (size < kLargestSize && meets(pair)) continue;
      const int behind = static_cast<int>(standing.size());
      for (Wheel& wheel : pair) wheel.partner += behind;
      standing.insert(standing.end(), pair.begin(), pair.end());
      break;
    }
  }
}

/// Do two wheels meet, now or while a carrier between them turns?
bool BevelArranger::meet(const Wheel& wheel, const Wheel& other) const {
  if (wheel.link == other.link) return false;
  if (areNear(wheel.hull, other.hull, m_margin)) return true;
  AxisGroupPath path;
  path.walk(m_classes, wheel.link, other.link);
  for (const int c : path.classes()) {
    if (c == wheel.axisGroup || c == other.axisGroup) continue;
    const auto& line = m_lines[m_classes.classes[c].axis];
    if (!line) continue;
    for (int i = 1; i < kTurns; ++i) {
      const double angle = 2 * std::numbers::pi * i / kTurns;
      if (areNear(turned(wheel.hull, line->point, line->direction, angle), other.hull, m_margin)) return true;
    }
  }
  return false;
}

/// Wheels of the pairs that stand about the same apex already are no obstacle to their partners.
bool BevelArranger::fits(const Wheels& wheels) const {
  const auto isSame = [](const Wheel& x, const Wheel& y) {
    return x.link == y.link && x.axisGroup == y.axisGroup && x.teeth == y.teeth &&
           length(x.hull.front().centre - y.hull.front().centre) < 1e-6 * y.hull.front().radius;
  };
  return std::none_of(wheels.begin(), wheels.end(), [&](const Wheel& wheel) {
    const auto meshIn = [&](const Wheels& list, const Wheel& other) {
      return std::any_of(list.begin(), list.end(), [&](const Wheel& same) {
        return isSame(same, wheel) && isSame(list[static_cast<std::size_t>(same.partner)], other);
      });
    };
    const auto meshesWith = [&](const Wheel& other) {
      return meshIn(wheels, other) || meshIn(m_standing, other);
    };
    return std::any_of(m_standing.begin(), m_standing.end(), [&](const Wheel& other) {
      return !isSame(wheel, other) && !meshesWith(other) && meet(wheel, other);
    });
  });
}

void BevelArranger::add(Wheels wheels) {
  const int behind = static_cast<int>(m_standing.size());
  for (Wheel& wheel : wheels) wheel.partner += behind;
  m_standing.insert(m_standing.end(), wheels.begin(), wheels.end());
}

int BevelArranger::place(int from, int to, const Vector3& direction, double module, int first) {
  const Line a = *m_lines[from];
  const Line b{{}, direction};
  m_margin = kMargin * module;
  setSizes(from, to, a, b, module);
  const auto at = [&](int step) {
    return wheelsBetween(from, to, a.point + (module * kStep * step) * a.direction, a, b, module);
  };
  std::vector<int> steps{first};
  for (int i = -kMaxArrangerSteps; i <= kMaxArrangerSteps; ++i) steps.push_back(i);
  for (int i = kMaxArrangerSteps; i < kMaxStep; steps.insert(steps.end(), {i, -i})) i += i / 6;
  const double against = m_rooted.contains(from) ? kBehindRoot : kAgainst;
  const auto cost = [&](int step) { return step < 0 ? -against * step : step; };
  std::stable_sort(steps.begin() + 1, steps.end(), [&](int x, int y) { return cost(x) < cost(y); });
  int chosen = first;
  if (m_standing.size() <= kMaxWheels) {
    const auto free = std::find_if(steps.begin(), steps.end(), [&](int step) { return fits(at(step)); });
    if (free != steps.end()) chosen = *free;
  }
  add(at(chosen));
  m_rooted.insert(to);
  return chosen;
}

void BevelArranger::stand(int from, int to, double module) {
  const Line& a = *m_lines[from];
  const Line& b = *m_lines[to];
  const Vector3 normal = cross(a.direction, b.direction);
  const double along = dot(cross(b.point - a.point, b.direction), normal) / dot(normal, normal);
  add(wheelsBetween(from, to, a.point + along * a.direction, a, b, module));
}

}  // namespace geargraph
