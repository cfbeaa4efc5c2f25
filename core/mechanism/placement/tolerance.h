#pragma once

#include <optional>
#include <span>

#include "core/mechanism/graph/digraph.h"
#include "core/mechanism/placement/axis_line.h"

namespace geargraph::inline placement {

// How geometry is compared. Nothing here depends on where a train is or how large it is; no rank, degree of
// freedom or zero of the analysis depends on it at all: its rows come from tooth counts.
//
// The numbers of a document are exact, whether whole, fractions or decimals, so what fits exactly always
// fits. Authors and other programs also write rounded decimals, which miss by a little; so does what
// follows from a square root. Therefore what misses by less than a small part of the train's own size
// fits as well. The distance from the origin is no such size.
//
// Differences of coordinates are taken in doubles where a bound on their rounding shows that the decision
// cannot change, and in fractions else.

/// Two lines are one where their directions differ by less (rad) and their distance is less, relative to the
/// train's size.
constexpr double kSameLine = 1e-6;
/// How far lengths may miss what they should be, relative to the pitch radii: decimals of five digits pass.
constexpr double kGeometryFits = 1e-4;

/// The same direction or the opposite one. @pre both of length 1
[[nodiscard]] inline bool areParallel(const Vector3& a, const Vector3& b) {
  const Vector3 normal = cross(a, b);
  return dot(normal, normal) <= kSameLine * kSameLine;
}

/// What subtracting coordinates of this size in doubles may lose, with the products that follow.
[[nodiscard]] constexpr double roundingOf(double coordinates) {
  constexpr double kUnits = 8;
  return kUnits * 2.220446049250313e-16 * coordinates;
}

/// |x| + |y| + |z|, an upper bound of the length.
[[nodiscard]] inline double reachOf(const Vector3& v) {
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

/// to - from, correctly rounded, whatever cancels. Cost: three fractions.
[[nodiscard]] Vector3 exactDifference(const ExactVector3& to, const ExactVector3& from);

/// Compares the lines that a document gives, by their axes' positions.
class LineComparison {
 public:
  /// `lines`: by axis; those that are automatic are never compared. Refers to all three.
  LineComparison(const Mechanism& mechanism, const Digraph& graph, std::span<const AxisLine> lines)
      : m_mechanism(mechanism), m_graph(graph), m_lines(lines) {}

  /// +1 or -1 where both are one line, pointing alike or against each other, else 0.
  /// @pre neither is automatic
  [[nodiscard]] int coincidence(int axis, int other) const;

  /// The train's size: the median distance between axes that one moving link or one mesh ties together,
  /// coincident ones left out; 0 where there are none. Neither the place of the train, nor the distance of
  /// two trains in one document, nor one mistyped coordinate counts. Cost: O(t + c), once, on demand.
  [[nodiscard]] double size() const;

 private:
  [[nodiscard]] double exactOffset(int axis, int other) const;
  [[nodiscard]] double medianDistance(bool exactly) const;

  const Mechanism& m_mechanism;
  const Digraph& m_graph;
  std::span<const AxisLine> m_lines;
  mutable std::optional<double> m_size;
};

/// Numbers that tell the given lines of a document apart: lines that coincidence() calls one have keys less
/// than `window` apart. Independent of place and size. Cost: O(axes).
struct LineKeys {
  explicit LineKeys(std::span<const AxisLine> lines);
  /// Infinite for an automatic line.
  [[nodiscard]] double of(const AxisLine& line, const Vector3& weights) const;

  Vector3 origin{};   ///< a point of the first given line
  double scale = 0;   ///< 1 / the largest distance of a line's point from there
  double window = 0;  ///< for weights of length 1 at most
};

}  // namespace geargraph::inline placement
