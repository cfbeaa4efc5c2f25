#include "core/mechanism/model/axis_letters.h"

#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/mechanism/model/fresh_ids.h"
#include "core/mechanism/model/load_edits.h"

namespace geargraph {
namespace {

/// The axes in the order of the joints that use them first, those without joints last.
std::vector<AxisId> axesInUse(const Mechanism& mechanism) {
  std::vector<AxisId> axes;
  std::unordered_set<InternedString> seen;
  const auto add = [&](AxisId axis) {
    if (seen.insert(axis.atom()).second) axes.push_back(axis);
  };
  for (const TurningJoint& joint : mechanism.turningJoints) add(joint.axis);
  for (const Axis& axis : mechanism.axes) add(axis.id);
  return axes;
}

std::vector<AxisId> runningLetters(std::size_t count) {
  return freshAxisIds(Mechanism(), static_cast<int>(count));
}

void rename(Mechanism& mechanism, const std::vector<AxisId>& from, const std::vector<AxisId>& to) {
  std::unordered_map<InternedString, AxisId> names;
  for (std::size_t i = 0; i < from.size(); ++i) names.emplace(from[i].atom(), to[i]);
  for (Axis& axis : mechanism.axes) axis.id = names.at(axis.id.atom());
  for (TurningJoint& joint : mechanism.turningJoints) joint.axis = names.at(joint.axis.atom());
  forEachLoadAxis(mechanism, [&names](std::optional<AxisId>& axis) {
    if (!axis) return;
    if (const auto now = names.find(axis->atom()); now != names.end()) axis = now->second;
  });
}

}  // namespace

bool doAxisLettersRun(const Mechanism& mechanism) {
  const std::vector<AxisId> axes = axesInUse(mechanism);
  return axes == runningLetters(axes.size());
}

Expected<Mechanism> withAxisLettersAsBefore(const Mechanism& before, Expected<Mechanism> edited) {
  if (!edited || !doAxisLettersRun(before)) return edited;
  Mechanism next = *std::move(edited);
  const std::vector<AxisId> axes = axesInUse(next);
  const std::vector<AxisId> letters = runningLetters(axes.size());
  if (axes != letters) rename(next, axes, letters);
  return next;
}

}  // namespace geargraph
