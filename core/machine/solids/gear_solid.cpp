#include "core/machine/solids/gear_solid.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/foundations/base/contract.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/solids/gear_mesher.h"
#include "core/machine/solids/spec_diagnostics.h"
#include "core/machine/solids/toothless_gear.h"
#include "core/machine/solids/wheel_form.h"

namespace geargraph {

namespace {

/// Sections of a helical wheel, so near to each other that no chord along the tips is farther than
/// `tolerance` (a length) from its helix.
std::vector<TwistLayer> layersOf(const GearSpec& spec, double tolerance) {
  if (spec.helixAngle == 0 || isConical(spec)) return {};
  const double half = spec.faceWidth / 2;
  const double slope = std::tan(spec.helixAngle) / pitchRadius(spec);
  const double reach = std::max(nominalTipRadius(spec), nominalRootRadius(spec));
  const auto layers = static_cast<int>(
      std::ceil(std::abs(slope) * half / (2 * std::acos(1 - std::min(tolerance / reach, 1.0)))));
  const int steps = std::max(layers, 1);  // of one half
  std::vector<TwistLayer> all;
  for (int i = -steps; i <= steps; ++i) {
    const double height = half * i / steps;
    const double turn = twistOf(spec, height);
    if (i <= 0 || !spec.herringbone) all.push_back({height, turn, slope});
    if (i >= 0 && spec.herringbone) all.push_back({height, turn, -slope});
  }
  return all;
}

}  // namespace

Expected<Solid> gearSolid(const GearSpec& spec, double tolerance) {
  GEARGRAPH_REQUIRE(tolerance > 0);
  Diagnostics wrong = specDiagnostics(spec);
  if (!wrong.empty()) return wrong;
  if (!isToothed(spec)) return toothlessGear(spec, tolerance);
  if (const auto solid = wheelForm(spec).solid; solid != nullptr) return solid(spec, tolerance);
  GearBlank blank;
  blank.teeth = spec.teeth;
  blank.inward = isRing(spec);
  blank.below = {bodyProfile(spec), bodyWindows(spec), tolerance * spec.module};
  blank.layers = layersOf(spec, blank.below.tolerance);
  blank.half = wheelForm(spec).toothFaces(toothOf(spec, tolerance), spec);
  if (const auto sections = wheelForm(spec).sections; sections != nullptr)
    blank.sections = sections(blank.half, spec, blank.below.tolerance);
  return meshed(blank);
}

std::size_t GearCache::KeyHash::operator()(const Key& key) const {
  const GearSpec& s = key.spec;
  std::size_t seed = static_cast<std::size_t>(s.teeth) * 16 + static_cast<std::size_t>(s.kind) * 2 +
                     static_cast<std::size_t>(s.body);
  seed = seed * 16 + static_cast<std::size_t>(s.mateTeeth);
  for (const double v : {s.module, s.pressureAngle, s.profileShift, s.backlashAllowance, s.addendum,
                         s.dedendum, s.rootRadius, s.tipRadius, s.coneAngle, s.faceWidth, s.bore, s.rim,
                         s.hub, s.helixAngle, s.mateRadius, key.tolerance}) {
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

}  // namespace geargraph
