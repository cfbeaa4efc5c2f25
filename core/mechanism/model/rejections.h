#pragma once

#include <string>
#include <vector>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Why an edit is rejected: an error of this code about these elements.
[[nodiscard]] Diagnostic rejection(Code code, std::string message, std::vector<ElementId> elements = {});

/// The document has no such element: unknown-id.
[[nodiscard]] Diagnostic unknownElement(const ElementId& element);

/// How sentences name an element: by its label, else its id.
[[nodiscard]] std::string labelOrId(const Mechanism& mechanism, const ElementId& element);

}  // namespace geargraph
