#pragma once

#include <cstddef>
#include <cstdint>

#include "core/foundations/base/diagnostic.h"
#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

constexpr std::size_t kMaxNameLength = 1'000;    ///< characters of a name, a unit or an id
constexpr std::size_t kMaxListLength = 100'000;  ///< elements of a list

/// Lengths, coordinates and components of directions are no larger than this, in whatever unit: their squares
/// and products stay far below the largest double or float, and every search over them terminates.
constexpr std::int64_t kLargestLength = 1'000'000'000'000'000;

/// Violations of the limits of the file format, one `schema` each: texts and lists beyond these limits;
/// lengths, coordinates, components of directions, positions of nodes and measures of wheels beyond
/// +-kLargestLength; directions shorter than its inverse; invalid notes (noteDiagnostics()). A document
/// without violations can be saved and opened again; edits reject any. Cost: O(n + t + c).
[[nodiscard]] Diagnostics limitDiagnostics(const Mechanism& mechanism);

/// The mechanism, or what limitDiagnostics() finds, without JSON pointers, because there is no file.
[[nodiscard]] Expected<Mechanism> checkedLimits(Mechanism mechanism);

}  // namespace geargraph
