#include "ui/canvas/drawn_joint.h"

#include <utility>
#include <vector>

#include "core/mechanism/model/drawn_mesh.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {
namespace {

/// Has it the teeth and the kind of a mesh that nothing is known of?
bool isAsDrawn(const GearMesh& mesh, const GearMesh& plain) {
  return mesh.tailTeeth == plain.tailTeeth && mesh.headTeeth == plain.headTeeth && !mesh.kind &&
         !mesh.pitchPoint;
}

/// With a mesh that was taken out, guessed anew.
Expected<Mechanism> withMeshAgain(const Mechanism& before, const GearMesh& mesh) {
  const Expected<Mechanism> plain = withGearMesh(before, mesh.tail, mesh.head);
  if (!plain) return plain;
  Expected<Mechanism> drawn = withDrawnMesh(before, mesh.tail, mesh.head);
  if (!drawn) return drawn;
  GearMesh again = mesh;
  if (isAsDrawn(mesh, plain->gearMeshes.back())) {
    const GearMesh& guessed = drawn->gearMeshes.back();
    again.tailTeeth = guessed.tailTeeth;
    again.headTeeth = guessed.headTeeth;
    again.kind = guessed.kind;
  }
  Mechanism after = *std::move(drawn);
  after.gearMeshes.back() = std::move(again);
  return after;
}

/// In the order in which they were drawn, those without a geometry after the others.
Expected<PlacedMechanism> withMeshesGuessedAgain(const PlacedMechanism& drawn) {
  const Mechanism& mechanism = drawn.mechanism();
  if (mechanism.gearMeshes.empty() || !drawn.placement().tree) return drawn;
  Mechanism after = mechanism;
  after.gearMeshes.clear();
  std::vector<GearMesh> lacking;
  for (std::size_t i = 0; i < mechanism.gearMeshes.size(); ++i) {
    const bool isPlaced = drawn.placement().meshes[i].has_value();
    (isPlaced ? after.gearMeshes : lacking).push_back(mechanism.gearMeshes[i]);
  }
  if (lacking.empty()) return drawn;
  for (const GearMesh& mesh : lacking) {
    Expected<Mechanism> next = withMeshAgain(after, mesh);
    if (!next) return drawn;
    after = *std::move(next);
  }
  std::vector<GearMesh> ordered;
  for (const GearMesh& mesh : mechanism.gearMeshes) ordered.push_back(*after.find(mesh.id));
  after.gearMeshes = std::move(ordered);
  return PlacedMechanism(std::move(after));
}

}  // namespace

Expected<PlacedMechanism> withDrawnJoint(const Mechanism& before, LinkId tail, LinkId head) {
  const Expected<PlacedMechanism> drawn = unplaced(withTurningJoint(before, tail, head));
  return drawn ? withMeshesGuessedAgain(*drawn) : drawn;
}

}  // namespace geargraph
