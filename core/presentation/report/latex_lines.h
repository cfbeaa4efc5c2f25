#pragma once

#include <string>

namespace geargraph {

/// A displayed formula of core's TeX, whose lines are broken before plus, minus and equals signs outside of
/// brackets and tables where they are wider than `width` (em, as typesetFormula() measures); what follows is
/// indented. The formula as it is where all its lines fit; a part without a break point stays wider.
/// Cost: that of typesetting the parts of wide lines.
[[nodiscard]] std::string brokenLines(const std::string& tex, double width);

}  // namespace geargraph
