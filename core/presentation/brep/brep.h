#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace geargraph {

// Solids by their exact faces, as CAD files have them, and the assembly of a file. What leaves here for
// geargraph-step is these values and nothing else, so that all geometry is decided, and tested, on this side.

/// Straight between its vertices.
struct LineCurve {};

/// An arc of a circle, counter-clockwise about `axis` (unit vector) from the first vertex to the second; the
/// whole circle where these are the same.
struct ArcCurve {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
};

/// A cubic B-spline with simple inner knots, that begins and ends at its outer poles.
struct SplineCurve {
  std::vector<double> knots;           ///< different ones, ascending; at least two
  std::vector<Eigen::Vector3d> poles;  ///< two more than knots
};

/// From one vertex to another.
struct BrepEdge {
  int from = 0;  ///< points of the solid
  int to = 0;
  std::variant<LineCurve, ArcCurve, SplineCurve> curve;
};

struct PlaneSurface {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< out of the material
};

/// A cylinder, or a cone about `axis` (unit vector). Its normal points away from the axis.
struct RoundSurface {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double radius = 1;  ///< at the origin
  double slope = 0;   ///< of the radius along the axis; 0: a cylinder
};

/// A B-spline surface, cubic along u (its poles fastest), cubic or straight along v. Its normal is that of
/// u x v. A face of it has one loop of four edges, its borders, from the corner at its first u and first v.
struct SplineSurface {
  std::vector<double> uKnots;
  std::vector<double> vKnots;  ///< straight: two
  bool isRuled = false;        ///< straight along v
  std::vector<Eigen::Vector3d> poles;
};

/// An edge of a loop, in or against its direction.
struct LoopEdge {
  int edge = 0;
  bool isForward = true;
};

struct BrepFace {
  std::variant<PlaneSurface, RoundSurface, SplineSurface> surface;
  bool isReversed = false;  ///< the material is on the side that the surface's normal points to
  /// Counter-clockwise seen from outside; the outer one first. Two loops of a RoundSurface, a whole circle
  /// each: the band between them.
  std::vector<std::vector<LoopEdge>> loops;
};

/// One closed solid: every edge is in two loops, once in each direction.
struct Brep {
  std::vector<Eigen::Vector3d> points;
  std::vector<BrepEdge> edges;
  std::vector<BrepFace> faces;
};

/// What is wrong with a solid as such, in a word for a programmer; std::nullopt: it is closed, edges begin
/// and end where they say, numbers are finite. Cost: O(edges)
[[nodiscard]] std::optional<std::string> flawOf(const Brep& solid);

/// A part of an assembly, in its own frame.
struct CadPart {
  std::string name;
  std::array<float, 3> colour{};  ///< sRGB, 0 to 1
  std::vector<Brep> solids;       ///< several: to be united
};

/// A part, or what belongs together, in its place.
struct CadNode {
  std::string name;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< to the parent's frame
  int parent = -1;                                         ///< a node before it; -1: the assembly
  int part = -1;                                           ///< -1: what the nodes below it make up
};

/// A CAD file. Lengths in mm.
struct CadAssembly {
  std::string name;
  std::string description;  ///< for the file's header: how near the surfaces are
  std::string program;
  std::vector<CadPart> parts;
  std::vector<CadNode> nodes;
};

/// The bytes between this program and geargraph-step.
[[nodiscard]] std::string packedAssembly(const CadAssembly& assembly);
/// std::nullopt if the bytes are not what packedAssembly() writes, or name what is not there.
[[nodiscard]] std::optional<CadAssembly> unpackedAssembly(std::string_view bytes);

}  // namespace geargraph
