#pragma once

#include <span>
#include <vector>

#include "core/foundations/exact/pi_number.h"
#include "core/foundations/exact/sparse_rows.h"
#include "core/mechanism/placement/placement.h"
#include "core/theory/matroid/kinematic_model.h"

namespace geargraph {

/// The angular velocity of one link relative to another, as sums over the phi of the kinematic model
/// (kinematic_model.h), one sum a direction: w = sum over the parts of (sum of factor * phi[link]) * u.
///
/// Directions count as one where they are parallel in the reference pose (placement's tolerance); along a run
/// of parallel axes they stay so in every motion.
struct RelativeSpeed {
  struct Term {
    LinkOrdinal link = 0;
    int factor = 1;  ///< +1 or -1
  };
  struct Part {
    AxisGroupOrdinal axisGroup = 0;  ///< u is the direction of its line
    std::vector<Term> terms;
  };
  std::vector<Part> parts;
  /// The runs of parallel axes along the path: the changes of direction plus one; 0 for a link against
  /// itself.
  int stretches = 0;

  /// Of `to` against `from`; from the ground (0) it is the absolute velocity.
  /// Cost: O(axis classes on the path).
  /// @pre the placement has a tree
  [[nodiscard]] static RelativeSpeed between(const Placement& placement, LinkOrdinal from, LinkOrdinal to);

  /// Do constant coefficients decide when the speed is 0? On three runs or fewer, every part has to vanish:
  /// two directions are independent, and three links of a spherical chain that closes are a rigid triangle,
  /// even where their axes are momentarily in one plane. Four directions or more make a linkage that moves
  /// and whose speeds depend on the pose.
  [[nodiscard]] bool closesWithoutLinkage() const { return stretches <= 3; }
};

/// A component of an absolute angular velocity: `speed` about the line of an axis class, rad/s; where the
/// class slides, of the travel along it, lengths a second.
template <class Value>
struct SpeedAboutOf {
  AxisGroupOrdinal axisGroup = 0;
  Value speed;
};
using SpeedAbout = SpeedAboutOf<Rational>;

/// The absolute angular velocity of a link as components about pairwise different directions, without those
/// that are 0; empty if the link is at rest. Cost: O(joints to the ground).
/// @pre the placement has a tree; a rate for every joint
[[nodiscard]] std::vector<SpeedAbout> absoluteSpeed(const Placement& placement,
                                                    std::span<const Rational> rates, LinkOrdinal link);
/// The same with powers of pi.
[[nodiscard]] std::vector<SpeedAboutOf<PiNumber>> absoluteSpeed(const Placement& placement,
                                                                std::span<const PiNumber> rates,
                                                                LinkOrdinal link);

/// +1 where the lines of two classes of one kind point the same way, -1 where opposite ways, 0 where they are
/// not parallel, or one turns and the other one slides.
[[nodiscard]] int directionSign(const Placement& placement, AxisGroupOrdinal oneClass,
                                AxisGroupOrdinal otherClass);

/// The value of a part, from the phi of all links.
template <class Field>
[[nodiscard]] typename Field::Value valueOf(const Field& field, const RelativeSpeed::Part& part,
                                            const std::vector<typename Field::Value>& phi) {
  typename Field::Value sum = field.fromInteger(0);
  for (const RelativeSpeed::Term& term : part.terms) {
    field.subtractProduct(sum, field.fromInteger(-term.factor), phi[static_cast<std::size_t>(term.link) - 1]);
  }
  return sum;
}

/// Adds a part as entries over the phi to the current row, without ending it.
template <class Field>
void addPart(SparseRows<typename Field::Value>& rows, const RelativeSpeed::Part& part, const Field& field) {
  for (const RelativeSpeed::Term& term : part.terms) rows.add(term.link - 1, field.fromInteger(term.factor));
}

}  // namespace geargraph
