#include <algorithm>
#include <optional>
#include <set>

#include "core/design/fixes/fix_makers.h"
#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/mechanism/model/edits.h"

namespace geargraph {
namespace {

constexpr int kMaxTriedLinks = 40;  // a try takes some ten times as long as the analysis of so small a train
constexpr int kMinUsualTeeth = 8;

bool trainSays(const Mechanism& mechanism, Code code) {
  const Placement placement = placementOf(mechanism);
  if (hasErrors(placement.diagnostics)) return true;
  const Diagnostics found = trainDiagnostics(mechanism, placement);
  return std::any_of(found.begin(), found.end(), [code](const Diagnostic& d) { return d.code == code; });
}

/// A sun, its ring, and the planets that mesh with both.
struct PlanetarySet {
  LinkId sun;
  LinkId ring;
  std::set<LinkId> planets;
  int sunTeeth = 0;
  int ringTeeth = 0;
};

struct MeshEnds {
  LinkId smaller;
  LinkId larger;
};

/// The link that holds the ring of an internal pair, and the planet in it.
MeshEnds endsOfInternal(const GearMesh& mesh) {
  const bool tailIsRing = mesh.tailTeeth > mesh.headTeeth;
  return tailIsRing ? MeshEnds{mesh.head, mesh.tail} : MeshEnds{mesh.tail, mesh.head};
}

int teethOn(const GearMesh& mesh, LinkId link) {
  return mesh.tail == link ? mesh.tailTeeth : mesh.headTeeth;
}

/// From one loop of two planets: the internal meshes name the ring, the others the sun.
std::optional<PlanetarySet> planetarySetOf(const Mechanism& mechanism, const Diagnostic& diagnostic) {
  PlanetarySet set;
  for (const ElementId& element : diagnostic.elements) {
    const GearMesh* mesh = mechanism.find(MeshId(element.id));
    if (mesh == nullptr || !hasRing(saidKind(*mesh))) continue;
    const MeshEnds ends = endsOfInternal(*mesh);
    if (!set.ring.empty() && set.ring != ends.larger) return std::nullopt;
    set.ring = ends.larger;
    set.ringTeeth = teethOn(*mesh, ends.larger);
  }
  if (set.ring.empty()) return std::nullopt;
  for (const GearMesh& mesh : mechanism.gearMeshes) {
    const bool ofRing = mesh.tail == set.ring || mesh.head == set.ring;
    if (ofRing) set.planets.insert(mesh.tail == set.ring ? mesh.head : mesh.tail);
  }
  for (const ElementId& element : diagnostic.elements) {
    const GearMesh* mesh = mechanism.find(MeshId(element.id));
    if (mesh == nullptr || mesh->tail == set.ring || mesh->head == set.ring) continue;
    const LinkId sun = set.planets.contains(mesh->tail) ? mesh->head : mesh->tail;
    if (!set.sun.empty() && set.sun != sun) return std::nullopt;
    set.sun = sun;
    set.sunTeeth = teethOn(*mesh, sun);
  }
  if (set.sun.empty() || set.planets.size() < 2) return std::nullopt;
  return set;
}

Expected<Mechanism> withSetTeeth(Mechanism mechanism, const PlanetarySet& set, int sun, int planet,
                                 int ring) {
  const auto teeth = [&](LinkId link) { return link == set.sun ? sun : link == set.ring ? ring : planet; };
  const auto inSet = [&](LinkId link) {
    return link == set.sun || link == set.ring || set.planets.contains(link);
  };
  const std::vector<GearMesh> meshes = mechanism.gearMeshes;
  for (const GearMesh& mesh : meshes) {
    if (!inSet(mesh.tail) || !inSet(mesh.head)) continue;
    Expected<Mechanism> next = withTeeth(std::move(mechanism), mesh.id, teeth(mesh.tail), teeth(mesh.head));
    if (!next) return next.error();
    next = withPitchPoint(std::move(next).value(), mesh.id, std::nullopt);  // it was that of the old teeth
    if (!next) return next.error();
    mechanism = std::move(next).value();
  }
  return mechanism;
}

/// Planets at equal distances fit where their number divides N_sun + N_ring, and stay coaxial where N_ring -
/// N_sun is twice their teeth. The nearest rings, then the nearest suns.
std::vector<Fix> assemblyFixes(const Diagnostic& diagnostic, const Mechanism& mechanism) {
  const auto set = planetarySetOf(mechanism, diagnostic);
  if (!set) return {};
  const int count = static_cast<int>(set->planets.size());
  std::vector<Fix> fixes;
  const auto offer = [&](int sun, int ring, bool isRing, const char* text) {
    const int planet = (ring - sun) / 2;
    if (sun < kMinUsualTeeth || planet < kMinUsualTeeth || (ring - sun) % 2 != 0) return;
    if ((sun + ring) % count != 0) return;
    fixes.push_back({filled(translated(text), {std::to_string(isRing ? ring : sun), std::to_string(planet)}),
                     [set = *set, sun, planet, ring](const Mechanism& before) {
                       return withSetTeeth(before, set, sun, planet, ring);
                     }});
  };
  for (int change = 0; change <= 2 * count; ++change) {
    for (const int sign : {1, -1}) {
      if (change == 0 && sign < 0) continue;
      const int ring = set->ringTeeth + sign * change;
      offer(set->sunTeeth, ring, true, toTranslate("Use %1 teeth on the ring and %2 on the planets"));
      const int sun = set->sunTeeth + sign * change;
      if (change > 0)
        offer(sun, set->ringTeeth, false, toTranslate("Use %1 teeth on the sun and %2 on the planets"));
    }
  }
  if (fixes.size() > 2 * kMaxFixes) fixes.resize(2 * kMaxFixes);
  fixes = tried(std::move(fixes), mechanism,
                [](const Mechanism& repaired) { return trainSays(repaired, Code::assembly); });
  const std::vector<Fix> ofCount = planetCountFixes(mechanism, *set->planets.begin());
  if (fixes.size() + ofCount.size() > kMaxFixes) fixes.resize(kMaxFixes - ofCount.size());
  fixes.insert(fixes.end(), ofCount.begin(), ofCount.end());
  return fixes;
}

/// All teeth multiplied: every ratio, and every condition on sums of teeth, stays as it was.
std::vector<Fix> undercutFixes(const Mechanism& mechanism) {
  std::vector<Fix> fixes;
  for (int factor = 2; factor <= 4; ++factor) {
    constexpr const char* kTexts[] = {toTranslate("Use twice the teeth everywhere"),
                                      toTranslate("Use three times the teeth everywhere"),
                                      toTranslate("Use four times the teeth everywhere")};
    fixes.push_back({translated(kTexts[factor - 2]), [factor](Mechanism before) -> Expected<Mechanism> {
                       const std::vector<GearMesh> meshes = before.gearMeshes;
                       for (const GearMesh& mesh : meshes) {
                         Expected<Mechanism> next = withTeeth(
                             std::move(before), mesh.id, mesh.tailTeeth * factor, mesh.headTeeth * factor);
                         if (!next) return next.error();
                         before = std::move(next).value();
                       }
                       return before;
                     }});
  }
  fixes = tried(std::move(fixes), mechanism,
                [](const Mechanism& repaired) { return trainSays(repaired, Code::undercut); });
  if (fixes.size() > 1) fixes.resize(1);  // the fewest teeth that do
  return fixes;
}

bool isLocked(const Mechanism& mechanism) {
  const SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(mechanism));
  return snapshot->matroid() == nullptr ||
         std::any_of(snapshot->diagnostics.begin(), snapshot->diagnostics.end(), [](const Diagnostic& found) {
           return found.code == Code::locked || found.code == Code::deadJoint ||
                  (found.severity() == Severity::error && found.code != Code::invalidInputs);
         });
}

/// One wheel of the loop with another tooth count, the nearest that agrees with the other ratios.
void addAgreeingTeeth(const Mechanism& mechanism, const GearMesh& mesh, std::vector<Fix>& fixes) {
  constexpr int kMaxDistance = 30;
  for (const bool ofTail : {false, true}) {
    const int now = ofTail ? mesh.tailTeeth : mesh.headTeeth;
    for (int step = 2; step <= 2 * kMaxDistance + 1; ++step) {
      const int teeth = now + (step % 2 == 0 ? 1 : -1) * (step / 2);
      if (teeth < kMinUsualTeeth) continue;
      const auto edit = [id = mesh.id, ofTail, teeth, mesh](const Mechanism& before) {
        return withTeeth(before, id, ofTail ? teeth : mesh.tailTeeth, ofTail ? mesh.headTeeth : teeth);
      };
      const Expected<Mechanism> repaired = edit(mechanism);
      if (!repaired || isLocked(*repaired)) continue;
      const std::string gear = labelOf(mechanism, ofTail ? mesh.tail : mesh.head).value_or("");
      fixes.push_back({translated("Use %1 teeth on gear %2 of %3",
                                  {std::to_string(teeth), gear, wordFor(mechanism, mesh.id)}),
                       edit});
      break;
    }
  }
}

std::vector<Fix> lockedFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  constexpr std::size_t kMaxMeshes = 3;
  const Mechanism& mechanism = *snapshot.mechanism;
  std::vector<Fix> fixes;
  std::vector<Fix> removals;
  std::size_t meshes = 0;
  for (const ElementId& element : diagnostic.elements) {
    const GearMesh* mesh =
        element.kind == ElementKind::gearMesh ? mechanism.find(MeshId(element.id)) : nullptr;
    if (mesh == nullptr || ++meshes > kMaxMeshes) continue;
    if (fixes.empty()) addAgreeingTeeth(mechanism, *mesh, fixes);
    removals.push_back(removalOf(snapshot, element));
  }
  if (fixes.size() > 1) fixes.resize(1);
  std::move(removals.rbegin(), removals.rend(), std::back_inserter(fixes));  // the one drawn last first
  return tried(std::move(fixes), mechanism, isLocked);
}

}  // namespace

std::vector<Fix> teethFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  const Mechanism& mechanism = *snapshot.mechanism;
  if (mechanism.n() > kMaxTriedLinks) return {};
  switch (diagnostic.code) {
    case Code::assembly:
      return diagnostic.detail == Detail::unequalPlanets ? unequalPlanetFixes(diagnostic, mechanism)
                                                         : assemblyFixes(diagnostic, mechanism);
    case Code::undercut:
      return undercutFixes(mechanism);
    default:
      return lockedFixes(diagnostic, snapshot);
  }
}

}  // namespace geargraph
