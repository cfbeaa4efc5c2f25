#pragma once

#include <string>
#include <string_view>

namespace geargraph {

/// A formula in core's subset of TeX (tex_reader.h) as MathML Core: the content of a <math> element. Rules of
/// arrays are classes: "bar" left of a cell, "rule" above it.
/// @pre the formula is in that subset
/// Cost: linear in its length.
[[nodiscard]] std::string mathMl(std::string_view tex);

}  // namespace geargraph
