#include "core/mechanism/model/pins.h"

#include <algorithm>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

template <class Element>
bool mark(std::vector<Element>& elements, const ElementId& wanted, bool pinned) {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const Element& element) { return ElementId(element.id) == wanted; });
  if (found == elements.end()) return false;
  found->pinned = pinned;
  return true;
}

}  // namespace

Expected<Mechanism> withPinMark(Mechanism mechanism, const ElementId& element, bool pinned) {
  if (mark(mechanism.axes, element, pinned) || mark(mechanism.links, element, pinned) ||
      mark(mechanism.gearMeshes, element, pinned))
    return mechanism;
  return Diagnostic{Code::unknownId,
                    translated("There is no axis, link or mesh \"%1\" to pin.", {element.id.text()}),
                    {element},
                    {},
                    0,
                    0};
}

}  // namespace geargraph
