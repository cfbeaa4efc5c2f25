#include "core/machine/solids/gear_solid.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/foundations/base/contract.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/gear_mesher.h"
#include "core/machine/solids/spec_diagnostics.h"
#include "core/machine/teeth/half_tooth.h"

namespace geargraph::inline solids {
namespace {

using Eigen::Vector3d;

bool sameCorner(const HalfTooth& tooth, std::size_t i) {
  return i > 0 && tooth.points[i].rad == tooth.points[i - 1].rad &&
         tooth.points[i].gam == tooth.points[i - 1].gam;
}

std::vector<OutlinePoint> cylinderOutline(const HalfTooth& tooth, const GearSpec& spec) {
  std::vector<OutlinePoint> outline;
  outline.reserve(tooth.points.size());
  for (std::size_t i = 0; i < tooth.points.size(); ++i) {
    const ProfilePoint& p = tooth.points[i];
    const double c = std::cos(p.gam);
    const double s = std::sin(p.gam);
    const double r = p.rad * spec.module;
    const Vector3d normal(p.normalRad * c - p.normalGam * s, p.normalRad * s + p.normalGam * c, 0);
    outline.push_back({{r * c, r * s, -spec.faceWidth / 2},
                       {r * c, r * s, spec.faceWidth / 2},
                       normal,
                       -Vector3d::UnitZ(),
                       Vector3d::UnitZ(),
                       sameCorner(tooth, i)});
  }
  return outline;
}

/// The rays of the tooth from the apex, cut by the back cone and the front cone.
std::vector<OutlinePoint> coneOutline(const HalfTooth& tooth, const GearSpec& spec) {
  const double large = coneDistance(spec);
  const double small = large - spec.faceWidth;
  std::vector<OutlinePoint> outline;
  outline.reserve(tooth.points.size());
  for (std::size_t i = 0; i < tooth.points.size(); ++i) {
    const ProfilePoint& p = tooth.points[i];
    const double c = std::cos(p.gam);
    const double s = std::sin(p.gam);
    const double sc = std::sin(p.rad);
    const double cc = std::cos(p.rad);
    const Vector3d ray = Vector3d(sc * c, sc * s, cc) / std::cos(p.rad - spec.coneAngle);
    const Vector3d alongRad(cc * c, cc * s, -sc);
    const Vector3d alongGam(-s, c, 0);
    const Vector3d back(std::sin(spec.coneAngle) * c, std::sin(spec.coneAngle) * s, std::cos(spec.coneAngle));
    outline.push_back({ray * small, ray * large, alongRad * p.normalRad + alongGam * p.normalGam, -back, back,
                       sameCorner(tooth, i)});
  }
  return outline;
}

}  // namespace

Expected<Solid> gearSolid(const GearSpec& spec, double tolerance) {
  GEARGRAPH_REQUIRE(tolerance > 0);
  Diagnostics wrong = specDiagnostics(spec);
  if (!wrong.empty()) return wrong;
  GearBlank blank;
  blank.teeth = spec.teeth;
  blank.inward = spec.kind == GearKind::internal;
  blank.tolerance = tolerance * spec.module;
  switch (spec.kind) {
    case GearKind::external:
      blank.half = cylinderOutline(externalTooth(spec, tolerance), spec);
      break;
    case GearKind::internal:
      blank.half = cylinderOutline(ringTooth(spec, tolerance), spec);
      break;
    case GearKind::bevel:
      blank.half = coneOutline(bevelTooth(spec, tolerance), spec);
      break;
  }
  blank.body = bodyProfile(spec);
  blank.windows = bodyWindows(spec);
  return meshed(blank);
}

std::size_t GearCache::KeyHash::operator()(const Key& key) const {
  const GearSpec& s = key.spec;
  std::size_t seed = static_cast<std::size_t>(s.teeth) * 8 + static_cast<std::size_t>(s.kind) * 2 +
                     static_cast<std::size_t>(s.body);
  for (const double v :
       {s.module, s.pressureAngle, s.profileShift, s.backlashAllowance, s.addendum, s.dedendum, s.rootRadius,
        s.tipRadius, s.coneAngle, s.faceWidth, s.bore, s.rim, s.hub, key.tolerance}) {
    seed = seed * 1000003 + std::hash<double>{}(v);
  }
  return seed;
}

Expected<std::shared_ptr<const DeferredSolid>> GearCache::deferred(const GearSpec& spec, double tolerance) {
  const std::lock_guard lock(m_mutex);
  const Key key{spec, tolerance};
  const auto found = m_solids.find(key);
  if (found != m_solids.end()) {
    found->second.used = ++m_calls;
    return found->second.solid;
  }
  Diagnostics wrong = specDiagnostics(spec);
  if (!wrong.empty()) return wrong;
  auto added =
      std::make_shared<const DeferredSolid>([spec, tolerance] { return gearSolid(spec, tolerance).value(); });
  m_solids[key] = {added, ++m_calls};
  if (m_solids.size() > m_capacity) dropOldest();
  return added;
}

Expected<std::shared_ptr<const Solid>> GearCache::solid(const GearSpec& spec, double tolerance) {
  auto found = deferred(spec, tolerance);
  if (!found) return found.error();
  return (*found)->solid();
}

std::size_t GearCache::size() const {
  const std::lock_guard lock(m_mutex);
  return m_solids.size();
}

void GearCache::makeRoomFor(std::size_t solids) {
  const std::lock_guard lock(m_mutex);
  m_capacity = std::max(m_capacity, 2 * solids);
}

void GearCache::dropOldest() {
  m_solids.erase(std::min_element(m_solids.begin(), m_solids.end(), [](const auto& a, const auto& b) {
    return a.second.used < b.second.used;
  }));
}

}  // namespace geargraph::inline solids
