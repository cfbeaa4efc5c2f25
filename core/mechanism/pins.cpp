#include "core/mechanism/pins.h"

#include <algorithm>

namespace geargraph {
namespace {

bool isMarked(const UnknownMembers& members) {
  return std::any_of(members.begin(), members.end(),
                     [](const auto& member) { return member.first == kPinned && member.second == "true"; });
}

template <class Element>
bool mark(std::vector<Element>& elements, const ElementId& wanted, bool pinned) {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const Element& element) { return ElementId(element.id) == wanted; });
  if (found == elements.end()) return false;
  std::erase_if(found->unknown, [](const auto& member) { return member.first == kPinned; });
  if (pinned) found->unknown.emplace_back(kPinned, "true");
  return true;
}

}  // namespace

bool isPinned(const Axis& axis) {
  return isMarked(axis.unknown);
}

bool isPinned(const Link& link) {
  return isMarked(link.unknown);
}

bool isPinned(const GearMesh& mesh) {
  return isMarked(mesh.unknown);
}

Expected<Mechanism> withPinMark(Mechanism mechanism, const ElementId& element, bool pinned) {
  if (mark(mechanism.axes, element, pinned) || mark(mechanism.links, element, pinned) ||
      mark(mechanism.gearMeshes, element, pinned))
    return mechanism;
  return Diagnostic{Code::unknownId,
                    "There is no axis, link or mesh \"" + element.id.text() + "\" to pin.",
                    {element},
                    {},
                    0,
                    0};
}

}  // namespace geargraph
