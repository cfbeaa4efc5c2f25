#include <algorithm>
#include <optional>
#include <set>

#include "core/design/fixes/fix_makers.h"
#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/complete_train.h"
#include "core/mechanism/model/edits.h"

namespace geargraph {
namespace {

constexpr int kMaxTriedLinks = 20;  // each try arranges the whole train

/// A try costs about 0.2 ms a link.
std::size_t mostTries(const Mechanism& mechanism) {
  return 300 / static_cast<std::size_t>(std::max(1, mechanism.n()));
}

bool isOverlap(const Diagnostic& diagnostic) {
  return diagnostic.detail == Detail::bodiesOverlap || diagnostic.detail == Detail::wheelsOverlap;
}

struct Overlaps {
  std::size_t count = 0;
  bool ofThese = false;  ///< of the links in question
};

/// std::nullopt where the train has no places any more.
std::optional<Overlaps> overlapsOf(const Mechanism& mechanism, const std::vector<ElementId>& links) {
  const Placement placement = placementOf(mechanism);
  if (hasErrors(placement.diagnostics)) return std::nullopt;
  Overlaps overlaps;
  for (const Diagnostic& found : trainDiagnostics(mechanism, placement)) {
    if (!isOverlap(found)) continue;
    ++overlaps.count;
    overlaps.ofThese = overlaps.ofThese || found.elements == links;
  }
  return overlaps;
}

/// Joints that carry these links, then those in which they carry others.
std::vector<JointId> jointsOf(const Mechanism& mechanism, const std::vector<ElementId>& links) {
  std::vector<JointId> joints;
  const auto add = [&](bool asHead) {
    for (const ElementId& link : links) {
      for (const TurningJoint& joint : mechanism.turningJoints) {
        const bool isOne = ElementId(asHead ? joint.head : joint.tail) == link;
        if (isOne && std::find(joints.begin(), joints.end(), joint.id) == joints.end())
          joints.push_back(joint.id);
      }
    }
  };
  add(true);
  add(false);
  return joints;
}

/// One try after the other until one clears the overlap: a joint further along its axis by some modules.
std::optional<Fix> offsetFix(const Mechanism& mechanism, const std::vector<ElementId>& links,
                             std::size_t before) {
  const Rational module = placementOf(mechanism).module;
  std::size_t tries = 0;
  const std::size_t most = mostTries(mechanism);
  for (const int modules : {40, 20, 60}) {
    for (const JointId id : jointsOf(mechanism, links)) {
      const TurningJoint& joint = *mechanism.find(id);
      for (const int sign : {1, -1}) {
        if (++tries > most) return std::nullopt;
        const Number offset(joint.offset.exact() + Rational(sign * modules) * module);
        const Expected<Mechanism> moved = withOffset(mechanism, id, offset);
        const std::optional<Overlaps> now = moved ? overlapsOf(*moved, links) : std::nullopt;
        if (!now || now->ofThese || now->count >= before) continue;
        return Fix{translated("Move %1 along its axis to %2 %3",
                              {wordFor(mechanism, id), offset.text(), mechanism.unit}),
                   [id, offset](const Mechanism& document) { return withOffset(document, id, offset); }};
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<Fix> overlapFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  const Mechanism& mechanism = *snapshot.mechanism;
  if (!isOverlap(diagnostic) || mechanism.n() > kMaxTriedLinks) return {};
  const std::optional<Overlaps> before = overlapsOf(mechanism, diagnostic.elements);
  if (!before || !before->ofThese) return {};
  const std::optional<Fix> fix = offsetFix(mechanism, diagnostic.elements, before->count);
  return fix ? std::vector<Fix>{*fix} : std::vector<Fix>{};
}

}  // namespace geargraph
