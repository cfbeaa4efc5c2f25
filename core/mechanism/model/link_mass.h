#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/mechanism/model/number.h"

namespace geargraph {

/// Moments and products of inertia: xx, yy, zz, xy, xz, yz. The products are those of the matrix: xy is
/// minus the sum of m x y.
using InertiaNumbers = std::array<Number, 6>;

/// The stated mass of a link. What is left out is computed from the link's solids.
struct LinkMass {
  Number mass;                           ///< kg, at least 0
  std::optional<NumberTriple> center{};  ///< in the reference pose, base frame, the document's unit
  /// kg m², about the centre of mass, along the axes of the base frame, in the reference pose.
  std::optional<InertiaNumbers> inertia{};
  friend bool operator==(const LinkMass&, const LinkMass&) = default;
};

constexpr int kSteelDensity = 7850;  ///< kg/m³, the default density

/// An error in a stated mass: the JSON member, and a sentence.
struct MassProblem {
  const char* member = "";
  std::string message;
};

/// A mass below 0, or an inertia that no body can have: its second moments (half the trace times the unit
/// matrix, less the inertia) have to be positive semidefinite, which includes the triangle inequality of the
/// principal moments. Decided in fractions. std::nullopt if the mass is valid. Cost: O(1).
[[nodiscard]] std::optional<MassProblem> massProblem(const LinkMass& mass);

}  // namespace geargraph
