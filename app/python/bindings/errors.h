#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/python/bindings/bindings.h"
#include "core/foundations/base/expected.h"

namespace geargraph::python {

/// The name of a kind: "link", "axis", "joint", "mesh", "wheel", "coupling", "state" or "load".
[[nodiscard]] std::string_view kindName(ElementKind kind);
/// The element with this kind and id; raises ValueError for an unknown kind.
[[nodiscard]] ElementId elementFrom(const std::string& kind, const std::string& id);

/// The diagnostics as tuples (severity, code, detail, message, ((kind, id), ...), pointer, line, column,
/// time).
[[nodiscard]] py::list rowsOf(const Diagnostics& diagnostics);

/// Raises geargraph.Error with these diagnostics.
[[noreturn]] void raise(const Diagnostics& diagnostics);
/// Raises geargraph.Error with a code that does not concern a document: "file", "limit" or "undefined".
[[noreturn]] void raise(std::string_view code, const std::string& message);

template <class Value>
[[nodiscard]] Value valueOrRaise(Expected<Value>&& expected) {
  if (!expected) raise(expected.error());
  return std::move(expected).value();
}

[[nodiscard]] inline py::bytes bytesOf(std::string_view bytes) {
  return {bytes.data(), bytes.size()};
}

/// Numbers as the bytes of a NumPy array.
template <class Number>
[[nodiscard]] py::bytes packed(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

}  // namespace geargraph::python
