#pragma once

namespace geargraph {

// Geometry in a file is written in decimals, so whether it fits is asked with these tolerances. No rank,
// degree of freedom or zero depends on them: the rows of the analysis come from tooth counts.

/// Two lines are one where their directions (rad) and places (relative to the coordinates) differ less.
constexpr double kSameLine = 1e-6;
/// How far lengths may miss what they should be, relative to the pitch radii: decimals of five digits pass.
constexpr double kGeometryFits = 1e-4;

}  // namespace geargraph
