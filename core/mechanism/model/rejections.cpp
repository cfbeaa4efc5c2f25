#include "core/mechanism/model/rejections.h"

#include "core/foundations/base/translation.h"

namespace geargraph {

Diagnostic rejection(Code code, std::string message, std::vector<ElementId> elements) {
  return {code, std::move(message), std::move(elements), {}, 0, 0};
}

Diagnostic unknownElement(const ElementId& element) {
  return rejection(Code::unknownId,
                   translated("There is no \"%1\" in %2.", {element.id.text(), listName(element.kind)}),
                   {element});
}

std::string labelOrId(const Mechanism& mechanism, const ElementId& element) {
  return labelOf(mechanism, element).value_or(element.id.text());
}

}  // namespace geargraph
