#include <algorithm>
#include <optional>

#include "core/design/fixes/fix_makers.h"
#include "core/design/synthesis/planets.h"
#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/machine/train/toothed_train.h"
#include "core/machine/train/train_diagnostics.h"
#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/placement/planet_groups.h"

namespace geargraph {
namespace {

constexpr int kMinPlanetTeeth = 8;

/// Do the teeth of all loops and of all equal planets fit? Without bodies, so that many tooth counts can be
/// tried.
bool assembles(const PlacedMechanism& placed) {
  const Placement& placement = placed.placement();
  if (!placement.tree || hasErrors(placement.diagnostics)) return false;
  const GearTrain train = toothedTrain(placed, shapedWheels(placed, placement));
  return assemblyDiagnostics(placed, train).empty() && planetDiagnostics(placed, placement, train).empty();
}

/// The set of equal planets that the link belongs to.
std::optional<std::vector<PlanetGroup>> planetsWith(const PlacedMechanism& placed, LinkId link) {
  if (!placed.placement().tree) return std::nullopt;
  for (auto& set : equalPlanets(placed, placed.placement(), PlanetScope::all)) {
    for (const PlanetGroup& group : set) {
      for (const LinkOrdinal each : group.links)
        if (placed.mechanism().links[each].id == link) return std::move(set);
    }
  }
  return std::nullopt;
}

Expected<Mechanism> withPlanetCount(const Mechanism& before, LinkId kept,
                                    const std::vector<ElementId>& others, int count) {
  const Expected<Mechanism> single = withoutElements(before, others);
  if (!single) return single.error();
  const Expected<PlacedMechanism> copied = withPlanets(PlacedMechanism(*single), kept, count);
  if (!copied) return copied.error();
  return copied->mechanism();
}

/// Do tips of the planets touch?
bool planetsTouch(const Mechanism& mechanism) {
  const Placement placement = placementOf(mechanism);
  if (hasErrors(placement.diagnostics)) return true;
  const Diagnostics found = trainDiagnostics(mechanism, placement);
  return std::any_of(found.begin(), found.end(), [](const Diagnostic& each) {
    return each.detail == Detail::planetsOverlap || each.code == Code::assembly;
  });
}

/// Both wheels of a mesh, so that their distance stays, or one of them.
struct TeethChange {
  MeshId mesh;
  int tail = 0;
  int head = 0;
};

std::vector<TeethChange> teethChanges(const Mechanism& mechanism, const PlanetGroup& planet) {
  constexpr int kMaxDistance = 8;
  std::vector<TeethChange> changes;
  for (int step = 1; step <= kMaxDistance; ++step) {
    for (const int change : {step, -step}) {
      for (const MeshOrdinal ordinal : planet.meshes) {
        const GearMesh& mesh = mechanism.gearMeshes[ordinal];
        const int opposite = hasRing(saidKind(mesh)) ? change : -change;
        changes.push_back({mesh.id, mesh.tailTeeth + change, mesh.headTeeth + opposite});
      }
      for (const MeshOrdinal ordinal : planet.meshes) {
        const GearMesh& mesh = mechanism.gearMeshes[ordinal];
        changes.push_back({mesh.id, mesh.tailTeeth + change, mesh.headTeeth});
        changes.push_back({mesh.id, mesh.tailTeeth, mesh.headTeeth + change});
      }
    }
  }
  return changes;
}

std::string textOf(const Mechanism& mechanism, const TeethChange& change) {
  const GearMesh& mesh = *mechanism.find(change.mesh);
  const std::string tail = labelOf(mechanism, mesh.tail).value_or("");
  const std::string head = labelOf(mechanism, mesh.head).value_or("");
  if (change.tail != mesh.tailTeeth && change.head != mesh.headTeeth)
    return translated("Use %1 teeth on gear %2 and %3 on gear %4",
                      {std::to_string(change.tail), tail, std::to_string(change.head), head});
  const bool ofTail = change.tail != mesh.tailTeeth;
  return translated("Use %1 teeth on gear %2 of %3", {std::to_string(ofTail ? change.tail : change.head),
                                                      ofTail ? tail : head, wordFor(mechanism, mesh.id)});
}

Expected<Mechanism> withChange(const Mechanism& before, const TeethChange& change) {
  const Expected<PlacedMechanism> fitted =
      withTeethFitted(PlacedMechanism(before), change.mesh, change.tail, change.head);
  if (!fitted) return fitted.error();
  return fitted->mechanism();
}

/// The nearest tooth counts with which planets of this number are equal parts.
void addTeeth(const Mechanism& mechanism, const PlanetGroup& planet, std::size_t most,
              std::vector<Fix>& fixes) {
  for (const TeethChange& change : teethChanges(mechanism, planet)) {
    if (fixes.size() >= most) return;
    if (std::min(change.tail, change.head) < kMinPlanetTeeth) continue;
    const Expected<Mechanism> repaired = withChange(mechanism, change);
    if (!repaired || !assembles(PlacedMechanism(*repaired))) continue;
    fixes.push_back({textOf(mechanism, change),
                     [change](const Mechanism& before) { return withChange(before, change); }});
  }
}

}  // namespace

std::vector<Fix> planetCountFixes(const Mechanism& mechanism, LinkId planet) {
  const auto set = planetsWith(PlacedMechanism(mechanism), planet);
  if (!set || set->front().links.size() != 1) return {};  // a copy is of one link
  const LinkId kept = mechanism.links[set->front().links.front()].id;
  std::vector<ElementId> others;
  for (std::size_t p = 1; p < set->size(); ++p)
    others.emplace_back(mechanism.links[(*set)[p].links.front()].id);
  const int count = static_cast<int>(set->size());
  for (int step = 1; step < 2 * count; ++step) {
    const int other = count + (step % 2 == 1 ? 1 : -1) * ((step + 1) / 2);
    if (other < 2) continue;
    const auto edit = [kept, others, other](const Mechanism& before) {
      return withPlanetCount(before, kept, others, other);
    };
    const Expected<Mechanism> repaired = edit(mechanism);
    if (!repaired || planetsTouch(*repaired)) continue;
    return {{translated("Use %1 equally spaced planets", {std::to_string(other)}), edit}};
  }
  return {};
}

std::vector<Fix> unequalPlanetFixes(const Diagnostic& diagnostic, const Mechanism& mechanism) {
  if (diagnostic.elements.empty()) return {};
  const LinkId planet(diagnostic.elements.front().id);
  const auto set = planetsWith(PlacedMechanism(mechanism), planet);
  if (!set) return {};
  std::vector<Fix> count = planetCountFixes(mechanism, planet);
  std::vector<Fix> fixes;
  addTeeth(mechanism, set->front(), kMaxFixes - count.size(), fixes);
  std::move(count.begin(), count.end(), std::back_inserter(fixes));
  return fixes;
}

}  // namespace geargraph
