#include "core/mechanism/model/slide_checks.h"

#include <vector>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"

namespace geargraph {

Diagnostic slidesNotCovered(const Mechanism& mechanism, const std::string& what) {
  constexpr std::size_t kMost = 8;
  Diagnostic diagnostic;
  diagnostic.code = Code::slidesNotCovered;
  std::vector<std::string> labels;
  for (int joint = 0; joint < mechanism.t(); ++joint) {
    const TurningJoint& each = mechanism.turningJoints[joint];
    if (!slides(each)) continue;
    labels.push_back(std::to_string(mechanism.jointLabel(joint)));
    diagnostic.elements.emplace_back(each.id);
  }
  diagnostic.message =
      translated("%1: sliding joints are not covered, and joints %2 slide.", {what, listed(labels, kMost)});
  return diagnostic;
}

}  // namespace geargraph
