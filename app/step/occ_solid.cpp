#include "app/step/occ_solid.h"

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <GProp_GProps.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace geargraph {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kSharp = 1e-7;  // OpenCASCADE's own least tolerance, mm
constexpr int kSamples = 8;      // places on a spline between two knots

gp_Pnt pointOf(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

gp_Dir directionOf(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

TColStd_Array1OfReal arrayOf(const std::vector<double>& numbers) {
  TColStd_Array1OfReal array(1, static_cast<int>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) array.SetValue(static_cast<int>(i) + 1, numbers[i]);
  return array;
}

/// How often each knot of a spline of this degree is repeated.
TColStd_Array1OfInteger multiplicities(std::size_t knots, int degree) {
  TColStd_Array1OfInteger array(1, static_cast<int>(knots));
  array.Init(1);
  array.SetValue(1, degree + 1);
  array.SetValue(static_cast<int>(knots), degree + 1);
  return array;
}

Handle(Geom_BSplineCurve) splineOf(const SplineCurve& spline) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(spline.poles.size()));
  for (std::size_t i = 0; i < spline.poles.size(); ++i)
    poles.SetValue(static_cast<int>(i) + 1, pointOf(spline.poles[i]));
  return new Geom_BSplineCurve(poles, arrayOf(spline.knots), multiplicities(spline.knots.size(), 3), 3);
}

Handle(Geom_BSplineSurface) patchOf(const SplineSurface& patch) {
  const int along = static_cast<int>(patch.uKnots.size()) + 2;
  const int across = static_cast<int>(patch.poles.size()) / along;
  TColgp_Array2OfPnt poles(1, along, 1, across);
  for (int v = 0; v < across; ++v) {
    for (int u = 0; u < along; ++u)
      poles.SetValue(u + 1, v + 1, pointOf(patch.poles[static_cast<std::size_t>(v * along + u)]));
  }
  const int degree = patch.isRuled ? 1 : 3;
  return new Geom_BSplineSurface(poles, arrayOf(patch.uKnots), arrayOf(patch.vKnots),
                                 multiplicities(patch.uKnots.size(), 3),
                                 multiplicities(patch.vKnots.size(), degree), 3, degree);
}

/// A face on a cylinder or a cone, and where points are on it.
struct Round {
  explicit Round(const RoundSurface& from) {
    // OpenCASCADE's cones widen along their axis.
    const double sense = from.slope < 0 ? -1 : 1;
    const gp_Ax3 frame(pointOf(from.origin), directionOf(sense * from.axis));
    if (from.slope == 0) {
      surface = new Geom_CylindricalSurface(frame, from.radius);
    } else {
      surface = new Geom_ConicalSurface(frame, std::atan(std::abs(from.slope)), from.radius);
    }
  }
  /// Angle and place along the axis, the angle as near as possible to another.
  [[nodiscard]] gp_Pnt2d at(const gp_Pnt& point, double near) const {
    double u = 0, v = 0;
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull()) {
      ElSLib::Parameters(cone->Cone(), point, u, v);
    } else {
      ElSLib::Parameters(Handle(Geom_CylindricalSurface)::DownCast(surface)->Cylinder(), point, u, v);
    }
    return {u + 2 * pi * std::round((near - u) / (2 * pi)), v};
  }

  Handle(Geom_ElementarySurface) surface;
};

/// Builds the shell of one solid.
class Maker {
 public:
  explicit Maker(const Brep& solid) : m_from(solid) {}

  TopoDS_Solid make() {
    for (const Vector3d& point : m_from.points) {
      m_builder.MakeVertex(m_vertices.emplace_back(), pointOf(point), kSharp);
    }
    for (const BrepEdge& edge : m_from.edges) addEdge(edge);
    TopoDS_Shell shell;
    m_builder.MakeShell(shell);
    for (const BrepFace& face : m_from.faces) {
      const TopoDS_Face made =
          std::visit([&](const auto& surface) { return faceOn(face, surface); }, face.surface);
      m_builder.Add(shell, face.isReversed ? made.Reversed() : TopoDS_Shape(made));
    }
    shell.Closed(Standard_True);
    TopoDS_Solid solid;
    m_builder.MakeSolid(solid);
    m_builder.Add(solid, shell);
    return solid;
  }

 private:
  [[nodiscard]] const BrepEdge& fromOf(const LoopEdge& edge) const {
    return m_from.edges[static_cast<std::size_t>(edge.edge)];
  }
  [[nodiscard]] const TopoDS_Edge& edgeOf(const LoopEdge& edge) const {
    return m_edges[static_cast<std::size_t>(edge.edge)];
  }
  [[nodiscard]] TopoDS_Vertex vertex(int point) const { return m_vertices[static_cast<std::size_t>(point)]; }

  void addEdge(const BrepEdge& edge);
  TopoDS_Face faceOn(const BrepFace& face, const PlaneSurface& plane);
  TopoDS_Face faceOn(const BrepFace& face, const RoundSurface& round);
  TopoDS_Face faceOn(const BrepFace& face, const SplineSurface& patch);
  TopoDS_Face band(const BrepFace& face, const Round& round);
  void lay(const LoopEdge& edge, const Round& round, double& angle);
  void loosen(const TopoDS_Edge& edge, const BrepEdge& from, double tolerance);
  /// Loops as seen against the face's own normal, if that points into the material.
  TopoDS_Wire wireOf(const std::vector<LoopEdge>& loop, bool isReversed);

  const Brep& m_from;
  BRep_Builder m_builder;
  std::vector<TopoDS_Vertex> m_vertices;
  std::vector<TopoDS_Edge> m_edges;
};

void Maker::addEdge(const BrepEdge& edge) {
  const gp_Pnt from = BRep_Tool::Pnt(vertex(edge.from)), to = BRep_Tool::Pnt(vertex(edge.to));
  Handle(Geom_Curve) curve;
  double first = 0, last = 0;
  if (const auto* arc = std::get_if<ArcCurve>(&edge.curve)) {
    const gp_Pnt centre = pointOf(arc->centre);
    const gp_Vec start(centre, from), end(centre, to);
    curve = new Geom_Circle(gp_Ax2(centre, directionOf(arc->axis), gp_Dir(start)), start.Magnitude());
    last = edge.from == edge.to ? 2 * pi : start.AngleWithRef(end, gp_Vec(directionOf(arc->axis)));
    if (last <= 0) last += 2 * pi;
  } else if (const auto* spline = std::get_if<SplineCurve>(&edge.curve)) {
    curve = splineOf(*spline);
    first = spline->knots.front();
    last = spline->knots.back();
  } else {
    curve = new Geom_Line(from, gp_Dir(gp_Vec(from, to)));
    last = from.Distance(to);
  }
  TopoDS_Edge& made = m_edges.emplace_back();
  m_builder.MakeEdge(made, curve, kSharp);
  m_builder.Add(made, vertex(edge.from).Oriented(TopAbs_FORWARD));
  m_builder.Add(made, vertex(edge.to).Oriented(TopAbs_REVERSED));
  m_builder.Range(made, first, last);
}

TopoDS_Wire Maker::wireOf(const std::vector<LoopEdge>& loop, bool isReversed) {
  TopoDS_Wire wire;
  m_builder.MakeWire(wire);
  const auto add = [&](const LoopEdge& edge) {
    const bool forward = edge.isForward != isReversed;
    m_builder.Add(wire, edgeOf(edge).Oriented(forward ? TopAbs_FORWARD : TopAbs_REVERSED));
  };
  if (isReversed) {
    for (auto edge = loop.rbegin(); edge != loop.rend(); ++edge) add(*edge);
  } else {
    for (const LoopEdge& edge : loop) add(edge);
  }
  wire.Closed(Standard_True);
  return wire;
}

TopoDS_Face Maker::faceOn(const BrepFace& face, const PlaneSurface& plane) {
  TopoDS_Face made;
  m_builder.MakeFace(made, new Geom_Plane(pointOf(plane.origin), directionOf(plane.normal)), kSharp);
  for (const auto& loop : face.loops) m_builder.Add(made, wireOf(loop, face.isReversed));
  return made;
}

void Maker::loosen(const TopoDS_Edge& edge, const BrepEdge& from, double tolerance) {
  m_builder.UpdateEdge(edge, tolerance);
  m_builder.UpdateVertex(vertex(from.from), tolerance);
  m_builder.UpdateVertex(vertex(from.to), tolerance);
}

/// Gives an edge its curve on a round surface. `angle`: where it begins in the direction of the loop, and
/// then where it ends.
void Maker::lay(const LoopEdge& edge, const Round& round, double& angle) {
  const TopoDS_Edge& made = edgeOf(edge);
  const BrepEdge& from = fromOf(edge);
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(made, first, last);
  std::vector<double> at{first};
  if (const auto* spline = std::get_if<SplineCurve>(&from.curve)) {
    at.clear();
    for (std::size_t i = 0; i + 1 < spline->knots.size(); ++i) {
      for (int k = 0; k < kSamples; ++k)
        at.push_back(spline->knots[i] + (spline->knots[i + 1] - spline->knots[i]) * k / kSamples);
    }
  } else if (std::holds_alternative<ArcCurve>(from.curve)) {
    for (int k = 1; k < kSamples; ++k) at.push_back(first + (last - first) * k / kSamples);
  }
  at.push_back(last);
  std::vector<gp_Pnt2d> places(at.size());
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::size_t i = edge.isForward ? k : at.size() - 1 - k;
    places[i] = round.at(curve->Value(at[i]), angle);
    angle = places[i].X();
  }
  Handle(Geom2d_Curve) flat;
  if (std::holds_alternative<SplineCurve>(from.curve)) {
    Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, static_cast<int>(at.size()));
    Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, static_cast<int>(at.size()));
    for (std::size_t i = 0; i < at.size(); ++i) {
      points->SetValue(static_cast<int>(i) + 1, places[i]);
      parameters->SetValue(static_cast<int>(i) + 1, at[i]);
    }
    Geom2dAPI_Interpolate interpolation(points, parameters, Standard_False, kSharp);
    interpolation.Perform();
    flat = interpolation.Curve();
  } else {  // along the axis or round it, by its length or its angle
    const gp_Vec2d way(places.front(), places.back());
    flat = new Geom2d_Line(places.front(), gp_Dir2d(way));
  }
  double farthest = kSharp;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const double middle = 0.5 * (at[i] + at[i + 1]);
    for (const double t : {at[i], middle, at[i + 1]}) {
      const gp_Pnt2d place = flat->Value(t);
      const gp_Pnt on = round.surface->Value(place.X(), place.Y());
      farthest = std::max(farthest, 1.5 * on.Distance(curve->Value(t)));
    }
  }
  m_builder.UpdateEdge(made, flat, round.surface, TopLoc_Location(), farthest);
  loosen(made, from, farthest);
}

TopoDS_Face Maker::faceOn(const BrepFace& face, const RoundSurface& surface) {
  const Round round(surface);
  if (face.loops.size() == 2) return band(face, round);
  double angle = 0;
  for (const LoopEdge& edge : face.loops.front()) lay(edge, round, angle);
  TopoDS_Face made;
  m_builder.MakeFace(made, round.surface, kSharp);
  m_builder.Add(made, wireOf(face.loops.front(), face.isReversed));
  return made;
}

/// Between two whole circles, with the seam that OpenCASCADE wants.
TopoDS_Face Maker::band(const BrepFace& face, const Round& round) {
  LoopEdge low = face.loops[0].front(), high = face.loops[1].front();
  const auto placeOf = [&](const LoopEdge& edge) {
    return round.at(pointOf(m_from.points[static_cast<std::size_t>(fromOf(edge).from)]), pi);
  };
  if (placeOf(low).Y() > placeOf(high).Y()) std::swap(low, high);
  const gp_Pnt2d bottom = placeOf(low);
  const gp_Pnt2d top(bottom.X(), placeOf(high).Y());
  const TopLoc_Location here;
  const gp_Vec up(round.surface->Axis().Direction());
  const auto turns = [&](const LoopEdge& edge) {  // does its own circle turn as the surface's angle grows?
    return gp_Vec(directionOf(std::get<ArcCurve>(fromOf(edge).curve).axis)).Dot(up) > 0;
  };
  const auto layCircle = [&](const LoopEdge& edge, const gp_Pnt2d& at) {
    const bool isForward = turns(edge);
    const gp_Pnt2d start(at.X() + (isForward ? 0 : 2 * pi), at.Y());
    m_builder.UpdateEdge(edgeOf(edge), new Geom2d_Line(start, gp_Dir2d(isForward ? 1 : -1, 0)), round.surface,
                         here, kSharp);
    return edgeOf(edge).Oriented(isForward ? TopAbs_FORWARD : TopAbs_REVERSED);
  };
  TopoDS_Edge seam;
  const TopoDS_Vertex from = vertex(fromOf(low).from), to = vertex(fromOf(high).from);
  const gp_Pnt start = BRep_Tool::Pnt(from), end = BRep_Tool::Pnt(to);
  m_builder.MakeEdge(seam, new Geom_Line(start, gp_Dir(gp_Vec(start, end))), kSharp);
  m_builder.Add(seam, from.Oriented(TopAbs_FORWARD));
  m_builder.Add(seam, to.Oriented(TopAbs_REVERSED));
  m_builder.Range(seam, 0, start.Distance(end));
  const gp_Dir2d along(0, 1);
  m_builder.UpdateEdge(seam, new Geom2d_Line(gp_Pnt2d(bottom.X() + 2 * pi, bottom.Y()), along),
                       new Geom2d_Line(bottom, along), round.surface, here, kSharp);
  m_builder.Continuity(seam, round.surface, round.surface, here, here, GeomAbs_CN);
  TopoDS_Wire wire;
  m_builder.MakeWire(wire);
  m_builder.Add(wire, layCircle(low, bottom));
  m_builder.Add(wire, seam.Oriented(TopAbs_FORWARD));
  m_builder.Add(wire, layCircle(high, top).Reversed());
  m_builder.Add(wire, seam.Oriented(TopAbs_REVERSED));
  wire.Closed(Standard_True);
  TopoDS_Face made;
  m_builder.MakeFace(made, round.surface, kSharp);
  m_builder.Add(made, wire);
  return made;
}

/// The edges of a patch are its borders, by the same parameter.
TopoDS_Face Maker::faceOn(const BrepFace& face, const SplineSurface& patch) {
  const Handle(Geom_BSplineSurface) surface = patchOf(patch);
  const TopLoc_Location here;
  const std::vector<LoopEdge>& loop = face.loops.front();
  const double u0 = patch.uKnots.front(), u1 = patch.uKnots.back();
  const double v0 = patch.vKnots.front(), v1 = patch.vKnots.back();
  const std::array<gp_Pnt2d, 4> corners{gp_Pnt2d(u0, v0), gp_Pnt2d(u1, v0), gp_Pnt2d(u1, v1),
                                        gp_Pnt2d(u0, v1)};
  for (std::size_t i = 0; i < 4; ++i) {
    gp_Pnt2d from = corners[face.isReversed ? (4 - i) % 4 : i];
    gp_Pnt2d to = corners[face.isReversed ? 3 - i : (i + 1) % 4];
    if (!loop[i].isForward) std::swap(from, to);
    const TopoDS_Edge& edge = edgeOf(loop[i]);
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    const bool alongU = from.Y() == to.Y();
    const double length = alongU ? to.X() - from.X() : to.Y() - from.Y();
    Handle(Geom2d_Curve) flat;
    if (std::abs(std::abs(length) - (last - first)) <= 1e-12 * std::abs(length) &&
        std::abs((length > 0) ? (alongU ? from.X() : from.Y()) - first : 0) <= 1e-12 * std::abs(length)) {
      const gp_Dir2d way(alongU ? length : 0, alongU ? 0 : length);
      const gp_Pnt2d start(from.X() - way.X() * first, from.Y() - way.Y() * first);
      flat = new Geom2d_Line(start, way);
    } else {
      TColgp_Array1OfPnt2d poles(1, 2);
      poles.SetValue(1, from);
      poles.SetValue(2, to);
      flat = new Geom2d_BSplineCurve(poles, arrayOf({first, last}), multiplicities(2, 1), 1);
    }
    double farthest = kSharp;
    for (int k = 0; k <= 2 * kSamples; ++k) {
      const double t = first + (last - first) * k / (2 * kSamples);
      const gp_Pnt2d place = flat->Value(t);
      farthest = std::max(farthest, 1.5 * surface->Value(place.X(), place.Y()).Distance(curve->Value(t)));
    }
    m_builder.UpdateEdge(edge, flat, surface, here, farthest);
    loosen(edge, fromOf(loop[i]), farthest);
  }
  TopoDS_Face made;
  m_builder.MakeFace(made, surface, kSharp);
  m_builder.Add(made, wireOf(loop, face.isReversed));
  return made;
}

}  // namespace

TopoDS_Solid occSolid(const Brep& solid) {
  return Maker(solid).make();
}

double volumeOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

bool isValid(const TopoDS_Shape& shape) {
  return BRepCheck_Analyzer(shape).IsValid();
}

TopoDS_Shape united(const std::vector<TopoDS_Solid>& solids) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Solid& solid : solids) builder.Add(all, solid);
  if (solids.size() < 2) return solids.empty() ? TopoDS_Shape(all) : TopoDS_Shape(solids.front());
  TopTools_ListOfShape first, others;
  first.Append(solids.front());
  for (std::size_t i = 1; i < solids.size(); ++i) others.Append(solids[i]);
  BRepAlgoAPI_Fuse fuse;
  fuse.SetArguments(first);
  fuse.SetTools(others);
  fuse.SetRunParallel(Standard_False);
  fuse.Build();
  if (fuse.HasErrors()) return all;
  const TopoDS_Shape whole = fuse.Shape();
  if (whole.IsNull() || !TopExp_Explorer(whole, TopAbs_SOLID).More() || !isValid(whole)) return all;
  // What is united is as large as the largest at least, and no larger than all together.
  double largest = 0, sum = 0;
  for (const TopoDS_Solid& solid : solids) {
    const double volume = volumeOf(solid);
    largest = std::max(largest, volume);
    sum += volume;
  }
  const double volume = volumeOf(whole);
  constexpr double kNear = 1e-4;
  return volume > (1 - kNear) * largest && volume < (1 + kNear) * sum ? whole : TopoDS_Shape(all);
}

}  // namespace geargraph
