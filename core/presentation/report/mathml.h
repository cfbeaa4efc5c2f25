#pragma once

#include <string>
#include <string_view>

namespace geargraph::inline report {

/// A formula in the TeX that core writes (tex_reader.h says which) as MathML Core, what goes between <math>
/// and
/// </math>. Rules of arrays are classes: "bar" left of a cell, "rule" above it.
/// @pre the formula uses no others: it is the program's own
/// Cost: linear in its length.
[[nodiscard]] std::string mathMl(std::string_view tex);

}  // namespace geargraph::inline report
