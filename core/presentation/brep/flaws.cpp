#include <algorithm>
#include <cmath>
#include <string>

#include "core/presentation/brep/brep.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

bool hasPoint(const Brep& solid, int point) {
  return point >= 0 && point < static_cast<int>(solid.points.size());
}

bool ascends(const std::vector<double>& knots) {
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    if (!(knots[i] < knots[i + 1])) return false;
  }
  return knots.size() >= 2;
}

/// How far the curve's ends are from where the edge says.
struct EndGap {
  const Vector3d& from;
  const Vector3d& to;
  double operator()(const LineCurve& /*line*/) const { return 0; }
  double operator()(const ArcCurve& arc) const {
    const double height = std::abs((to - from).dot(arc.axis));
    return std::max(height, std::abs((to - arc.centre).norm() - (from - arc.centre).norm()));
  }
  double operator()(const SplineCurve& spline) const {
    if (!ascends(spline.knots) || spline.poles.size() != spline.knots.size() + 2) return HUGE_VAL;
    return std::max((spline.poles.front() - from).norm(), (spline.poles.back() - to).norm());
  }
};

bool fits(const SplineSurface& surface) {
  const std::size_t across = surface.isRuled ? 2 : surface.vKnots.size() + 2;
  return ascends(surface.uKnots) && ascends(surface.vKnots) &&
         (!surface.isRuled || surface.vKnots.size() == 2) &&
         surface.poles.size() == (surface.uKnots.size() + 2) * across;
}

}  // namespace

std::optional<std::string> flawOf(const Brep& solid) {
  double size = 0;
  for (const Vector3d& point : solid.points) {
    if (!point.allFinite()) return "a point that is no number";
    size = std::max(size, point.norm());
  }
  for (std::size_t i = 0; i < solid.edges.size(); ++i) {
    const BrepEdge& edge = solid.edges[i];
    const std::string which = "edge " + std::to_string(i);
    if (!hasPoint(solid, edge.from) || !hasPoint(solid, edge.to)) return which + " between no points";
    const Vector3d& from = solid.points[static_cast<std::size_t>(edge.from)];
    const Vector3d& to = solid.points[static_cast<std::size_t>(edge.to)];
    if (!(std::visit(EndGap{from, to}, edge.curve) <= 1e-9 * size))
      return which + " does not end at its points";
  }
  std::vector<int> forward(solid.edges.size(), 0), backward(solid.edges.size(), 0);
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    const BrepFace& face = solid.faces[f];
    const std::string which = "face " + std::to_string(f);
    const auto* patch = std::get_if<SplineSurface>(&face.surface);
    if (patch != nullptr && (!fits(*patch) || face.loops.size() != 1 || face.loops[0].size() != 4))
      return which + " is no patch";
    if (face.loops.empty()) return which + " has no loop";
    for (const auto& loop : face.loops) {
      if (loop.empty()) return which + " has an empty loop";
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const LoopEdge& here = loop[i];
        const LoopEdge& next = loop[(i + 1) % loop.size()];
        if (here.edge < 0 || next.edge < 0 || here.edge >= static_cast<int>(solid.edges.size()) ||
            next.edge >= static_cast<int>(solid.edges.size()))
          return which + " has an edge that is not there";
        const BrepEdge& a = solid.edges[static_cast<std::size_t>(here.edge)];
        const BrepEdge& b = solid.edges[static_cast<std::size_t>(next.edge)];
        if ((here.isForward ? a.to : a.from) != (next.isForward ? b.from : b.to))
          return which + " has an open loop";
        ++(here.isForward ? forward : backward)[static_cast<std::size_t>(here.edge)];
      }
    }
  }
  for (std::size_t i = 0; i < solid.edges.size(); ++i) {
    if (forward[i] != 1 || backward[i] != 1)
      return "edge " + std::to_string(i) + " is in " + std::to_string(forward[i]) + " and " +
             std::to_string(backward[i]) + " loops";
  }
  return std::nullopt;
}

}  // namespace geargraph
