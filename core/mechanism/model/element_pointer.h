#pragma once

#include <cstddef>
#include <string>

#include "core/foundations/base/id.h"

namespace geargraph {

/// JSON pointer [RFC 6901] to an element of a document's list: "/links/3".
[[nodiscard]] inline std::string pointerTo(ElementKind list, std::size_t position) {
  return "/" + std::string(listName(list)) + "/" + std::to_string(position);
}

}  // namespace geargraph
