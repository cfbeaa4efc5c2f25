#pragma once

#include <optional>
#include <span>

#include "core/mechanism/graph/digraph.h"
#include "core/mechanism/placement/axis_line.h"

namespace geargraph {

// How geometry is compared. The result depends neither on the place nor on the size of a train. No rank,
// degree of freedom or zero of the analysis depends on these tolerances: its rows come from tooth counts.
//
// The numbers of a document are exact, whether whole, fractions or decimals, so an exact fit is always
// accepted. Users and other programs also write rounded decimals, which deviate slightly, and so do values
// derived by square roots. Therefore deviations below a small fraction of the train's own size are accepted
// too. The distance from the origin does not count as size.
//
// Differences of coordinates are taken in doubles where a bound on their rounding shows that the decision
// cannot change, else in fractions.

/// Two lines coincide if their directions differ by less than this (rad) and their distance relative to the
/// train's size is less too.
constexpr double kSameLine = 1e-6;
/// The tolerance of lengths, relative to the pitch radii: decimals of five digits pass.
constexpr double kGeometryFits = 1e-4;

/// The same direction or the opposite one. @pre both of length 1
[[nodiscard]] inline bool areParallel(const Vector3& a, const Vector3& b) {
  const Vector3 normal = cross(a, b);
  return dot(normal, normal) <= kSameLine * kSameLine;
}

/// A bound on the rounding error of subtracting coordinates of this size in doubles, with the products that
/// follow.
[[nodiscard]] constexpr double roundingOf(double coordinates) {
  constexpr double kUnits = 8;
  return kUnits * 2.220446049250313e-16 * coordinates;
}

/// |x| + |y| + |z|, an upper bound of the length.
[[nodiscard]] inline double reachOf(const Vector3& v) {
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

/// to - from, correctly rounded in spite of cancellation. Cost: three fractions.
[[nodiscard]] Vector3 exactDifference(const ExactVector3& to, const ExactVector3& from);

/// Compares the lines that a document gives, by their axes' positions.
class LineComparison {
 public:
  /// `lines`: by axis; automatic ones are never compared. All three arguments outlive this object.
  LineComparison(const Mechanism& mechanism, const Digraph& graph, SpanByAxis<const AxisLine> lines)
      : m_mechanism(mechanism), m_graph(graph), m_lines(lines) {}

  /// +1 or -1 if both are one line, with equal or opposite directions, else 0.
  /// @pre neither is automatic
  [[nodiscard]] int coincidence(AxisOrdinal axis, int other) const;

  /// The train's size: the median distance between axes that share a moving link or a mesh, without
  /// coincident ones; 0 if there are none. So the place of the train, the distance between two trains in one
  /// document and a single mistyped coordinate have no influence. Not thread-safe on the first call. Cost:
  /// O(t + c), once, on demand.
  [[nodiscard]] double size() const;

 private:
  [[nodiscard]] double exactOffset(AxisOrdinal axis, int other) const;
  [[nodiscard]] double medianDistance(bool exactly) const;

  const Mechanism& m_mechanism;
  const Digraph& m_graph;
  SpanByAxis<const AxisLine> m_lines;
  mutable std::optional<double> m_size;
};

/// Sort keys of the given lines of a document: the keys of lines that coincidence() regards as one differ by
/// less than `window`. Independent of place and size. Cost: O(axes).
struct LineKeys {
  explicit LineKeys(SpanByAxis<const AxisLine> lines);
  /// Infinite for an automatic line.
  [[nodiscard]] double of(const AxisLine& line, const Vector3& weights) const;

  Vector3 origin{};   ///< a point of the first given line
  double scale = 0;   ///< 1 / the largest distance of a line's point from there
  double window = 0;  ///< for weights of length 1 at most
};

}  // namespace geargraph
