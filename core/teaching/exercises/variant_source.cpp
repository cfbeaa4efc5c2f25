#include "core/teaching/exercises/variant_source.h"

#include <algorithm>

#include "core/mechanism/geometry_edits/fitted_edits.h"
#include "core/mechanism/model/edits.h"

namespace geargraph {
namespace {

constexpr std::uint64_t kMechanismStream = 1'000'000;  ///< of random numbers; questions have those from 0 on
constexpr int kMaxAttempts = 6;
constexpr int kMaxChangedMeshes = 2;
constexpr int kMinVariantTeeth = 12;
constexpr int kMaxAdded = 9;

/// Errors and warnings, the complete analysis included.
std::size_t faultsOf(const ExerciseSource& source) {
  const SnapshotPtr complete = analyzeFully(source.snapshot(), {false});
  return static_cast<std::size_t>(
      std::count_if(complete->diagnostics.begin(), complete->diagnostics.end(),
                    [](const Diagnostic& diagnostic) { return diagnostic.severity() != Severity::info; }));
}

/// The same list in another order, from `first` on.
template <class List>
void shuffle(List& list, int first, ExerciseRandom& random) {
  for (int last = static_cast<int>(list.size()) - 1; last > first; --last)
    std::swap(list[static_cast<std::size_t>(random.between(first, last))],
              list[static_cast<std::size_t>(last)]);
}

/// Arrows turned round, and labels exchanged: those of links (but the ground's), joints and meshes.
Mechanism relabelled(Mechanism mechanism, ExerciseRandom& random) {
  std::vector<ElementId> arrows;
  for (const TurningJoint& joint : mechanism.turningJoints) arrows.emplace_back(joint.id);
  for (const GearMesh& mesh : mechanism.gearMeshes) arrows.emplace_back(mesh.id);
  for (const ElementId& arrow : arrows) {
    if (random.below(2) == 0) mechanism = withFlipped(std::move(mechanism), arrow).value();
  }
  shuffle(mechanism.links, 1, random);
  shuffle(mechanism.turningJoints, 0, random);
  shuffle(mechanism.gearMeshes, 0, random);
  return mechanism;
}

/// Changes of the teeth of tail and head.
struct TeethChange {
  int tail = 0;
  int head = 0;
};

/// For each variant another one, as long as there are any.
TeethChange changeOf(const SheetPlan& plan, int variant) {
  constexpr int kStep = 97;  // has no factor in common with their number
  constexpr int kWidth = 2 * kMaxAdded + 1;
  const int first = ExerciseRandom(plan.seed, 0, kMechanismStream).below(kWidth * kWidth);
  const int place = (first + kStep * variant) % (kWidth * kWidth);
  return {place % kWidth - kMaxAdded, place / kWidth - kMaxAdded};
}

/// Other teeth in one mesh, and by chance in a second one, where they fit.
Mechanism withOtherTeeth(const Mechanism& mechanism, TeethChange change, ExerciseRandom& random) {
  PlacedMechanism placed(mechanism);
  const int meshes = mechanism.c();
  const auto other = [](int teeth, int added) { return std::max(kMinVariantTeeth, teeth + added); };
  for (int changes = random.between(1, kMaxChangedMeshes); changes > 0 && meshes > 0; --changes) {
    const GearMesh& mesh = placed.mechanism().gearMeshes[static_cast<std::size_t>(random.below(meshes))];
    const auto edited = withTeethFitted(placed, mesh.id, other(mesh.tailTeeth, change.tail),
                                        other(mesh.headTeeth, change.head));
    if (edited) placed = *edited;
    change = {random.between(-kMaxAdded, kMaxAdded), 0};
    if (meshes == 1) break;
  }
  return placed.mechanism();
}

bool supports(const ExerciseSource& source, const SheetPlan& plan) {
  return std::none_of(plan.kinds.begin(), plan.kinds.end(),
                      [&](ExerciseKind kind) { return reasonAgainst(source, kind).has_value(); });
}

bool movesLike(const ExerciseSource& a, const ExerciseSource& b) {
  if (a.matroid() == nullptr || b.matroid() == nullptr) return a.matroid() == b.matroid();
  return a.matroid()->rank == b.matroid()->rank && a.matroid()->dof == b.matroid()->dof;
}

}  // namespace

ExerciseSource variantSource(const ExerciseSource& source, const SheetPlan& plan, int variant) {
  if (plan.variants <= 1) return source;
  ExerciseRandom random(plan.seed, static_cast<std::uint64_t>(variant), kMechanismStream);
  const bool hasGeometry = source.matroid() != nullptr && source.graph().c() > 0;
  const std::size_t faults = hasGeometry ? faultsOf(source) : 0;
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    // The last attempts leave the teeth as they are.
    const bool changesTeeth = hasGeometry && attempt < kMaxAttempts - 2;
    const Mechanism teeth = changesTeeth ? withOtherTeeth(source.mechanism(), changeOf(plan, variant), random)
                                         : source.mechanism();
    ExerciseSource varied(relabelled(teeth, random));
    if (!supports(varied, plan) || !movesLike(varied, source)) continue;
    if (!changesTeeth || faultsOf(varied) <= faults) return varied;
  }
  return source;
}

}  // namespace geargraph
