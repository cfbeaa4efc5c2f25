#include "core/presentation/print_kit/kit_wheel.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/foundations/base/contract.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/gear_solid.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/meshfile/weld.h"

namespace geargraph {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kSameHeight = 1e-4;   // mm
constexpr double kMarkMargin = 0.6;    // mm between engravings and edges
constexpr double kLeastMark = 0.7;     // mm
constexpr double kGreatestMark = 1.6;  // mm

double onGridHeight(double z) {
  return std::round(z / KitShell::kGrid) * KitShell::kGrid;
}

/// The teeth of a wheel without its two flat faces: triangles in the print frame, and the closed edges that
/// the faces leave, the outermost first, each with the material on its left.
struct ToothSurface {
  std::vector<std::array<Vector3d, 3>> triangles;
  std::vector<KitOutline> low;
  std::vector<KitOutline> high;
  double height = 0;
  double second = 0;  ///< the lowest height of a point above the lower face
};

std::vector<KitOutline> loopsAt(const std::map<std::uint32_t, std::uint32_t>& after,
                                const std::vector<Vector3d>& points, double height) {
  std::vector<KitOutline> loops;
  std::map<std::uint32_t, bool> seen;
  for (const auto& [from, to] : after) {
    if (seen[from] || std::abs(points[from].z() - height) > kSameHeight) continue;
    KitOutline loop;
    for (std::uint32_t at = from; !seen[at]; at = after.at(at)) {
      seen[at] = true;
      loop.push_back(points[at].head<2>());
      if (!after.contains(at)) break;
    }
    loops.push_back(std::move(loop));
  }
  std::sort(loops.begin(), loops.end(), [](const KitOutline& a, const KitOutline& b) {
    return std::abs(doubledArea(a)) > std::abs(doubledArea(b));
  });
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if ((doubledArea(loops[i]) > 0) != (i == 0)) std::reverse(loops[i].begin(), loops[i].end());
  }
  return loops;
}

ToothSurface toothSurface(const Solid& solid, const Isometry3d& toPrint, double height) {
  const WeldedMesh mesh = welded(moved(solid, toPrint));
  ToothSurface surface;
  surface.height = height;
  surface.second = height;
  std::vector<Vector3d> points;
  for (const Float3& p : mesh.positions) {
    const Vector2d flat = KitShell::onGrid({p[0], p[1]});
    double z = p[2];
    if (std::abs(z) < kSameHeight) z = 0;
    if (std::abs(z - height) < kSameHeight) z = height;
    if (z != 0) surface.second = std::min(surface.second, z);
    points.emplace_back(flat.x(), flat.y(), z);
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> edges;
  for (const Triangle& t : mesh.triangles) {
    const auto isAt = [&](double z) {
      return points[t[0]].z() == z && points[t[1]].z() == z && points[t[2]].z() == z;
    };
    if (isAt(0) || isAt(height)) continue;
    surface.triangles.push_back({points[t[0]], points[t[1]], points[t[2]]});
    for (std::size_t k = 0; k < 3; ++k) edges[{t[k], t[(k + 1) % 3]}] = true;
  }
  std::map<std::uint32_t, std::uint32_t> after;
  for (const auto& [edge, is] : edges) {
    if (!edges.contains({edge.second, edge.first})) after[edge.first] = edge.second;
  }
  surface.low = loopsAt(after, points, 0);
  surface.high = loopsAt(after, points, height);
  return surface;
}

/// The outline of teeth with thinner and shorter teeth, point by point; a tooth keeps a third of its width.
KitOutline thinner(const KitOutline& teeth, int count, double first, bool isInward, double by) {
  double low = 1e300, high = 0;
  for (const Vector2d& p : teeth) {
    low = std::min(low, p.norm());
    high = std::max(high, p.norm());
  }
  const double depth = high - low, shorter = std::min(by, 0.3 * depth), pitch = 2 * pi / count;
  KitOutline made;
  for (const Vector2d& p : teeth) {
    const double r = p.norm();
    const double angle = std::atan2(p.y(), p.x()) - first;
    const double centre = std::round(angle / pitch) * pitch;
    const double off = angle - centre;
    const double above = (isInward ? high - r : r - low) / (0.3 * depth);
    const double thin = std::max(std::abs(off) - by * std::clamp(above, 0.0, 1.0) / r, 0.35 * std::abs(off));
    const double radius = isInward ? std::max(r, low + shorter) : std::min(r, high - shorter);
    const double turned = first + centre + std::copysign(thin, off);
    made.emplace_back(radius * std::cos(turned), radius * std::sin(turned));
  }
  return made;
}

/// Engravings of one face, outlines counter-clockwise as seen from above in the print frame.
struct Engraving {
  std::vector<KitOutline> outlines;
  std::vector<bool> hasMark;
  bool hasNumber = false;
};

bool isClear(const std::vector<KitOutline>& others, const Vector2d& at, double radius) {
  return std::all_of(others.begin(), others.end(), [&](const KitOutline& other) {
    const std::span<const KitOutline> one(&other, 1);
    return !isInside(one, at) && distanceTo(one, at) > radius + kMarkMargin;
  });
}

/// Marks in a row towards the body, within the band from `near` to `far` from the axis.
bool addMark(std::vector<KitOutline>& outlines, const std::vector<KitOutline>& holes, const WheelMark& mark,
             double angle, double near, double far, double module) {
  const Vector2d way(std::cos(angle), std::sin(angle));
  const double sense = far < near ? -1 : 1, room = std::abs(far - near);
  std::vector<KitOutline> blocked = outlines;
  blocked.insert(blocked.end(), holes.begin(), holes.end());
  for (double size = std::clamp(0.6 * module, kLeastMark, kGreatestMark); size >= kLeastMark - 1e-9;
       size -= 0.15) {
    const double length = mark.count * size + (mark.count - 1) * kMarkMargin;
    if (length > room) continue;
    std::vector<KitOutline> made;
    for (int i = 0; i < mark.count; ++i) {
      const double radius = near + sense * (size / 2 + i * (size + kMarkMargin));
      const Vector2d at = radius * way;
      if (!isClear(blocked, at, size / 2)) break;
      made.push_back(mark.isSpace ? boxOutline(at, way, 0.9 * size, 0.9 * size)
                                  : circleOutline(at, size / 2, 12));
    }
    if (static_cast<int>(made.size()) < mark.count) continue;
    outlines.insert(outlines.end(), made.begin(), made.end());
    return true;
  }
  return false;
}

std::vector<KitOutline> mirrored(std::vector<KitOutline> outlines) {
  for (KitOutline& outline : outlines) {
    for (Vector2d& p : outline) p.x() = -p.x();
    std::reverse(outline.begin(), outline.end());
  }
  return outlines;
}

/// The largest digits for which there is room in a face.
bool addNumber(std::vector<KitOutline>& outlines, std::vector<KitOutline> face, const std::string& number,
               bool isBelow) {
  for (const KitOutline& mark : outlines) face.push_back(reversed(mark));
  for (const double height : {7.0, 5.5, 4.5, 3.6, 3.0}) {
    Vector2d centre;
    if (!roomFor(face, {digitsWidth(number, height), height}, 0.8, centre)) continue;
    std::vector<KitOutline> digits = digitOutlines(number, height);
    if (isBelow) digits = mirrored(std::move(digits));
    for (KitOutline& digit : digits) outlines.push_back(shifted(std::move(digit), centre));
    return true;
  }
  return false;
}

}  // namespace

double heightOf(const GearSpec& spec) {
  const std::vector<ProfileVertex> body = bodyProfile(spec);
  const AxialSpan span{body.back().height, body.front().height};
  return onGridHeight(std::abs(span.high - span.low));
}

Isometry3d printFrameOf(const GearSpec& spec, bool isFlipped, double below) {
  const std::vector<ProfileVertex> body = bodyProfile(spec);
  const double low = std::min(body.front().height, body.back().height);
  const double high = std::max(body.front().height, body.back().height);
  Isometry3d place = Isometry3d::Identity();
  if (isFlipped) {
    place.translate(Vector3d(0, 0, high + below));
    place.rotate(Eigen::AngleAxisd(pi, Vector3d::UnitX()));
  } else {
    place.translate(Vector3d(0, 0, low - below));
  }
  return place;
}

double toothAngle(const WheelRequest& wheel, double tooth, bool atTop) {
  const double half = heightOf(wheel.spec) / 2;
  const bool isUpper = atTop != wheel.isFlipped;  // in the gear's frame
  const double angle = 2 * pi * tooth / wheel.spec.teeth +
                       (isConical(wheel.spec) ? 0 : twistOf(wheel.spec, isUpper ? half : -half));
  return wheel.isFlipped ? -angle : angle;
}

Expected<MadeWheel> printedWheel(const WheelRequest& wheel, double tolerance) {
  GearSpec spec = wheel.spec;
  spec.body = GearBody::plain;
  spec.bore = 0;
  const Expected<Solid> toothed = gearSolid(spec, tolerance);
  if (!toothed) return toothed.error();
  MadeWheel made;
  made.place = printFrameOf(spec, wheel.isFlipped);
  const double height = heightOf(spec);
  ToothSurface surface = toothSurface(*toothed, made.place.inverse(), height);
  const bool isCone = isConical(spec), ring = isRing(spec);
  GEARGRAPH_REQUIRE(surface.low.size() == (ring ? 2U : 1U) && surface.high.size() == surface.low.size());
  const double chamfer = std::min(wheel.chamfer, 0.6 * surface.second);
  const double first = toothAngle(wheel, 0, false);
  // The wall below the teeth's own surface: narrower at the bed.
  const double lift = std::max(chamfer, 0.0), below = ring ? wheel.below : 0;
  KitShell shell;
  for (auto triangle : surface.triangles) {
    for (Vector3d& p : triangle) p.z() = (p.z() == 0 && below == 0 ? lift : p.z()) + below;
    shell.addTriangle(triangle[0], triangle[1], triangle[2]);
  }
  const double top = height + below;
  std::vector<KitOutline> bottom, upper = surface.high;
  for (std::size_t i = 0; i < surface.low.size(); ++i) {
    const KitOutline& own = surface.low[i];
    const bool hasTeeth = !isCone && (ring ? i == 1 : i == 0);
    const KitOutline narrow = hasTeeth ? thinner(own, spec.teeth, first, ring, lift) : inset(own, lift);
    if (ring && wheel.floor > 0 && i == 1) {  // straight down to the floor
      shell.addWall(std::vector<Rim>{{wheel.floor, own}, {below > 0 ? below : lift, own}});
      continue;
    }
    std::vector<Rim> wall{{0, narrow}, {lift, own}};
    if (below > 0) wall.push_back({below, own});
    if (lift <= 0) wall.erase(wall.begin());
    shell.addWall(wall);
    bottom.push_back(lift > 0 ? narrow : own);
  }
  std::vector<std::vector<Rim>> holes = wheel.holes;
  const double boreTop = wheel.floor > 0 ? wheel.floor : top;
  for (const KitOutline& bore : wheel.bore) holes.push_back(chamferedWall(reversed(bore), 0, boreTop, lift));
  std::vector<KitOutline> floor;
  if (ring && wheel.floor > 0) floor.push_back(reversed(surface.low[1]));
  std::vector<KitOutline> pierced;
  for (const std::vector<Rim>& hole : holes) {
    shell.addWall(hole);
    bottom.push_back(hole.front().outline);
    const bool endsAtFloor = wheel.floor > 0 && hole.back().height < top - kSameHeight;
    (endsAtFloor ? floor : upper).push_back(hole.back().outline);
    pierced.push_back(reversed(hole.back().outline));
    pierced.push_back(reversed(hole.front().outline));
  }
  // Engravings: in a circle within the roots (rings: outside of them).
  const bool isBelow = isCone;
  const std::vector<KitOutline>& face = isBelow ? bottom : upper;
  double inner = 0, outer = 0;
  const double edge = isCone ? 1e300 : nominalRootRadius(spec);
  if (ring) {
    inner = edge + kMarkMargin;
    outer = rimDiameter(spec) / 2 - kMarkMargin;
  } else {
    double reach = edge;
    if (isCone) {
      for (const Vector2d& p : face.front()) reach = std::min(reach, p.norm());
    }
    outer = reach - kMarkMargin;
    for (const KitOutline& bore : wheel.bore) {
      for (const Vector2d& p : bore) inner = std::max(inner, p.norm());
    }
    inner += kMarkMargin + lift;
  }
  Engraving engraved;
  for (const WheelMark& mark : wheel.marks) {
    const double angle = toothAngle(wheel, mark.tooth + (mark.isSpace ? 0.5 : 0.0), !isBelow);
    const bool isOutward = ring;
    engraved.hasMark.push_back(addMark(engraved.outlines, pierced, mark, angle, isOutward ? inner : outer,
                                       isOutward ? outer : inner, spec.module));
  }
  if (!wheel.number.empty()) {
    std::vector<KitOutline> region;
    if (ring) {
      region = {circleOutline({0, 0}, outer + kMarkMargin),
                reversed(circleOutline({0, 0}, inner - kMarkMargin))};
    } else {
      region = {circleOutline({0, 0}, outer + kMarkMargin)};
    }
    for (const KitOutline& hole : pierced) region.push_back(reversed(hole));
    engraved.hasNumber = addNumber(engraved.outlines, std::move(region), wheel.number, isBelow);
  }
  constexpr double kDepth = 0.6;
  bool isMade = true;
  for (const KitOutline& pocket : engraved.outlines) {
    const KitOutline hole = reversed(pocket);
    const double at = isBelow ? 0 : top, end = isBelow ? kDepth : top - kDepth;
    (isBelow ? bottom : upper).push_back(hole);
    shell.addWall(isBelow ? std::vector<Rim>{{at, hole}, {end, hole}}
                          : std::vector<Rim>{{end, hole}, {at, hole}});
    isMade = shell.addFace(std::vector<KitOutline>{pocket}, end, !isBelow) && isMade;
  }
  isMade = shell.addFace(bottom, 0, false) && isMade;
  isMade = shell.addFace(upper, top, true) && isMade;
  if (!floor.empty()) isMade = shell.addFace(floor, wheel.floor, true) && isMade;
  made.solid = isMade ? shell.solid() : Solid{};
  made.hasMark = std::move(engraved.hasMark);
  made.hasNumber = engraved.hasNumber;
  made.overhang = isCone ? std::max(0.0, pi / 2 - spec.coneAngle) : 0;
  made.place = printFrameOf(spec, wheel.isFlipped, below);
  return made;
}

}  // namespace geargraph
