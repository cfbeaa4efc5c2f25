#include "core/machine/solids/gear_mesher.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
using Index = std::uint32_t;

/// Position and normal of one vertex in the frame of tooth 0.
struct Seed {
  Vector3d position;
  Vector3d normal;
};

Vector3d mirrored(const Vector3d& v) {
  return {v.x(), -v.y(), v.z()};
}

/// A point of a cylinder's wall in the section of a layer, where the wall is a helicoid: its normal is across
/// the profile and across the direction in which the section's points move along the axis.
Seed twisted(const Seed& wall, const TwistLayer& layer) {
  const double c = std::cos(layer.turn);
  const double s = std::sin(layer.turn);
  const auto turned = [&](double x, double y, double z) { return Vector3d(c * x - s * y, s * x + c * y, z); };
  const Vector3d& p = wall.position;
  const Vector3d& n = wall.normal;
  return {turned(p.x(), p.y(), layer.height),
          turned(n.x(), n.y(), layer.slope * (p.y() * n.x() - p.x() * n.y())).normalized()};
}

/// A vector turned about the axis.
Vector3d turned(const Vector3d& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z()};
}

/// A point of a section, where turning differs from place to place: what moves on in the wall by d is turned
/// by slope . d more, so that the normal gives way by that.
Seed turnedSeed(const WallPoint& point, bool mirror) {
  const auto seen = [&](const Vector3d& v) { return mirror ? mirrored(v) : v; };
  const Vector3d position = seen(point.position), normal = seen(point.normal), slope = seen(point.slope);
  const Vector3d across(-position.y(), position.x(), 0);
  return {turned(position, point.turn),
          turned((normal - across.dot(normal) * slope).normalized(), point.turn)};
}

/// The vertices and triangles of one tooth, which every tooth repeats turned. A wall loop of one tooth has
/// `walls` vertices, a face loop `faces`; index `walls` (`faces`) of a tooth is index 0 of the next.
class ToothPattern {
 public:
  explicit ToothPattern(const GearBlank& blank) : m_blank(blank) {
    findUnique();
    seedWalls();
    if (!blank.layers.empty()) twistWalls();
    if (!blank.sections.empty()) seedSections();
    seedFaces();
  }

  std::vector<std::vector<Seed>> walls;  ///< by layer, from the bottom face to the top face
  std::vector<char> isEdge;              ///< by layer: no wall between it and the next one
  std::vector<Seed> faceBottom, faceTop;
  double bottomTurn = 0, topTurn = 0;           ///< of the faces
  std::vector<std::array<Index, 2>> wallEdges;  ///< consecutive wall vertices with a face between them
  std::vector<Triangle> faceTriangles;          ///< of the top face, counter-clockwise
  std::vector<Index> wallOfFace;                ///< wall vertex at the place of a face vertex
  std::vector<Index> base;                      ///< face vertices of the polygon that the body is sewn to
  std::vector<double> baseAngles;               ///< before they are turned
  std::vector<double> bottomTurns, topTurns;    ///< of the base

 private:
  void findUnique();
  void seedWalls();
  void twistWalls();
  void seedSections();
  void seedFaces();
  void ladder();
  void sewTip(std::size_t top, std::size_t corner, std::size_t last);
  [[nodiscard]] std::size_t firstRung() const;
  [[nodiscard]] bool rungsStep(std::size_t from, std::size_t to) const;

  /// Face vertex of the mirrored (y <= 0) and of the given (y >= 0) half, by unique point.
  [[nodiscard]] Index right(std::size_t u) const { return static_cast<Index>(u); }
  [[nodiscard]] Index left(std::size_t u) const { return static_cast<Index>(2 * (m_unique.size() - 1) - u); }

  const GearBlank& m_blank;
  std::vector<std::size_t> m_unique;  ///< indices of `half` without the second side of corners
  std::vector<double> m_reach;  ///< how far towards the tip each unique point is, along the tooth's middle
  std::vector<std::array<double, 2>> m_faceTurns;  ///< of face vertices, bottom and top, by `sections`
  std::vector<double> m_bow;  ///< how far its rung sinks below the face, which is a cone in bevels
};

void ToothPattern::findUnique() {
  for (std::size_t i = 0; i < m_blank.half.size(); ++i) {
    if (!m_blank.half[i].corner) m_unique.push_back(i);
  }
  GEARGRAPH_REQUIRE(m_unique.size() >= 3);
  const Vector3d tip = m_blank.half.back().top;
  const Vector3d root = m_blank.half.front().top;
  const Vector3d up(tip.x() - std::hypot(root.x(), root.y()), 0, tip.z() - root.z());
  for (const std::size_t i : m_unique) {
    const Vector3d& p = m_blank.half[i].top;
    m_reach.push_back((p.x() * up.x() + p.z() * up.z()) / up.norm());
    m_bow.push_back((std::hypot(p.x(), p.y()) - p.x()) * m_blank.half.back().topNormal.x());
  }
}

void ToothPattern::seedWalls() {
  const auto& half = m_blank.half;
  const std::size_t last = half.size() - 1;
  walls.resize(2);
  isEdge = {0, 1};
  const auto add = [&](const OutlinePoint& p, bool mirror) {
    const auto seen = [&](const Vector3d& v) { return mirror ? mirrored(v) : v; };
    walls[0].push_back({seen(p.bottom), seen(p.wallNormal)});
    walls[1].push_back({seen(p.top), seen(p.wallNormal)});
  };
  for (std::size_t i = 0; i <= last; ++i) {
    if (i > 0 && !half[i].corner) wallEdges.push_back({Index(i - 1), Index(i)});
    add(half[i], true);
  }
  for (std::size_t i = last; i-- > 0;) {
    const auto here = static_cast<Index>(2 * last - i);
    if (!half[i + 1].corner) wallEdges.push_back({here - 1, here});
    if (i > 0) add(half[i], false);
  }
}

/// Sections of the cylinder instead of its two ends.
void ToothPattern::twistWalls() {
  const std::vector<Seed> straight = std::move(walls.front());
  const std::vector<TwistLayer>& layers = m_blank.layers;
  walls.clear();
  isEdge.assign(layers.size(), 0);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    std::vector<Seed>& wall = walls.emplace_back();
    wall.reserve(straight.size());
    for (const Seed& seed : straight) wall.push_back(twisted(seed, layers[i]));
    isEdge[i] = i + 1 == layers.size() || layers[i].height == layers[i + 1].height;
  }
  bottomTurn = layers.front().turn;
  topTurn = layers.back().turn;
}

void ToothPattern::seedSections() {
  walls.clear();
  isEdge.assign(m_blank.sections.size(), 0);
  isEdge.back() = 1;
  for (const std::vector<WallPoint>& section : m_blank.sections) {
    std::vector<Seed>& wall = walls.emplace_back();
    for (const WallPoint& point : section) wall.push_back(turnedSeed(point, true));
    for (std::size_t i = section.size() - 1; i-- > 1;) wall.push_back(turnedSeed(section[i], false));
  }
}

void ToothPattern::seedFaces() {
  const auto& half = m_blank.half;
  const std::size_t last = m_unique.size() - 1;
  const auto wallLast = static_cast<Index>(half.size() - 1);
  const auto add = [&](std::size_t u, bool mirror) {
    const OutlinePoint& p = half[m_unique[u]];
    const auto seen = [&](const Vector3d& v) { return mirror ? mirrored(v) : v; };
    const auto at = static_cast<Index>(m_unique[u]);
    const bool isTurned = !m_blank.sections.empty();
    const double down = isTurned ? m_blank.sections.front()[at].turn : 0;
    const double up = isTurned ? m_blank.sections.back()[at].turn : 0;
    faceBottom.push_back(
        {seen(p.bottom), isTurned ? turned(seen(p.bottomNormal), down) : seen(p.bottomNormal)});
    faceTop.push_back({seen(p.top), isTurned ? turned(seen(p.topNormal), up) : seen(p.topNormal)});
    m_faceTurns.push_back({down, up});
    wallOfFace.push_back(mirror ? at : 2 * wallLast - at);
  };
  for (std::size_t u = 0; u <= last; ++u) add(u, true);
  for (std::size_t u = last; u-- > 1;) add(u, false);
  ladder();
}

/// Do the rungs of these points make a strip that lies in the face: farther towards the tip, and not steep
/// against a conical face.
bool ToothPattern::rungsStep(std::size_t from, std::size_t to) const {
  const double step = m_reach[to] - m_reach[from];
  return step > 0 && std::abs(m_bow[to] - m_bow[from]) <= 0.2 * step;
}

/// Below the first rung that can be reached, the points belong to the polygon of the body.
std::size_t ToothPattern::firstRung() const {
  std::size_t corner = 0;  // the farthest point: the tip's middle, or a ring's tip corner
  for (std::size_t u = 1; u < m_reach.size(); ++u) {
    if (m_reach[u] > m_reach[corner] + 1e-9 * std::abs(m_reach[corner])) corner = u;
  }
  while (corner > 0 && !rungsStep(corner - 1, corner)) --corner;
  std::size_t first = std::min(corner, m_reach.size() - 2);
  while (first > 0 && rungsStep(first - 1, first)) --first;
  return first;
}

void ToothPattern::ladder() {
  const std::size_t last = m_unique.size() - 1;
  const std::size_t first = firstRung();
  std::size_t corner = first;
  while (corner < last && rungsStep(corner, corner + 1)) ++corner;
  // A ring's tip arc bulges back into the tooth, a bevel's lies across its cone: the ladder ends at a rung
  // that lies below all of it, and either half of what is left is sewn from the corner.
  std::size_t top = corner == last ? last - 1 : std::max(corner, first + 1) - 1;
  while (top > first && m_reach[top] >= m_reach[last]) --top;
  for (std::size_t u = first; u < top; ++u) {
    faceTriangles.push_back({right(u), right(u + 1), left(u + 1)});
    faceTriangles.push_back({right(u), left(u + 1), left(u)});
  }
  faceTriangles.push_back({right(top), right(last), left(top)});
  if (top + 1 < last) sewTip(top, std::max(corner, top + 1), last);
  for (std::size_t u = 0; u <= first; ++u) base.push_back(right(u));
  for (std::size_t u = first; u > 0; --u) base.push_back(left(u));
  if (first == 0) base.resize(1);
  for (const Index v : base)
    baseAngles.push_back(std::atan2(faceTop[v].position.y(), faceTop[v].position.x()));
  for (const Index v : base) {
    bottomTurns.push_back(bottomTurn + m_faceTurns[v][0]);
    topTurns.push_back(topTurn + m_faceTurns[v][1]);
  }
}

/// Sews the flank between a rung and the tip's corner to the tip between the corner and its middle, on both
/// sides: both bend towards each other, so that the shorter diagonal lies within.
void ToothPattern::sewTip(std::size_t top, std::size_t corner, std::size_t last) {
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    faceTriangles.push_back({right(a), right(b), right(c)});
    faceTriangles.push_back({left(a), left(c), left(b)});
  };
  const auto apart = [&](std::size_t a, std::size_t b) {
    return (m_blank.half[m_unique[a]].top - m_blank.half[m_unique[b]].top).squaredNorm();
  };
  std::size_t flank = corner - 1;
  std::size_t tip = corner + 1;
  add(flank, corner, tip);
  while (flank > top || tip < last) {
    if (tip == last || (flank > top && apart(flank - 1, tip) < apart(flank, tip + 1))) {
      add(flank - 1, flank, tip);
      --flank;
    } else {
      add(flank, tip, tip + 1);
      ++tip;
    }
  }
}

struct Turn {
  double c;
  double s;
};

/// Writes all teeth of a seed loop.
void repeat(const std::vector<Seed>& seeds, const std::vector<Turn>& turns, Float3* positions,
            Float3* normals) {
  for (const Turn& t : turns) {
    for (const Seed& seed : seeds) {
      const Vector3d& p = seed.position;
      const Vector3d& n = seed.normal;
      if (positions != nullptr) {
        *positions++ = {static_cast<float>(t.c * p.x() - t.s * p.y()),
                        static_cast<float>(t.s * p.x() + t.c * p.y()), static_cast<float>(p.z())};
      }
      *normals++ = {static_cast<float>(t.c * n.x() - t.s * n.y()),
                    static_cast<float>(t.s * n.x() + t.c * n.y()), static_cast<float>(n.z())};
    }
  }
}

/// The vertices and triangles of walls and faces, and where the loops that the body needs begin.
class ToothedShell {
 public:
  /// `circle`: vertices of each circle of the body, which finds its room here.
  ToothedShell(const GearBlank& blank, const ToothPattern& pattern, std::size_t circle, Solid& solid)
      : m_teeth(static_cast<Index>(blank.teeth)), m_inward(blank.inward), m_pattern(pattern), m_solid(solid) {
    m_walls = static_cast<Index>(pattern.walls.front().size());
    m_faces = static_cast<Index>(pattern.faceTop.size());
    m_layers = static_cast<Index>(pattern.walls.size());
    const auto strips = static_cast<std::size_t>(std::count(pattern.isEdge.begin(), pattern.isEdge.end(), 0));
    const std::size_t triangles = 2 * strips * pattern.wallEdges.size() + 2 * pattern.faceTriangles.size();
    const std::size_t vertices = m_teeth * (std::size_t{m_layers} * m_walls + 2 * std::size_t{m_faces});
    const std::size_t windows = blank.below.windows ? vertices / 16 + 4 * circle : 0;
    const std::size_t body = 2 * circle * blank.below.body.size() + windows;
    const std::size_t joints = 2 * m_teeth * pattern.base.size();  // between the faces and the body
    m_solid.positions.reserve(vertices + body);
    m_solid.normals.reserve(vertices + body);
    m_solid.triangles.reserve(m_teeth * triangles + joints + 2 * circle + body + windows);
    m_solid.positions.resize(vertices);
    m_solid.normals.resize(m_solid.positions.size());
    m_solid.triangles.resize(m_teeth * triangles);
    writeVertices();
    writeTriangles();
  }

  /// `start`: angle of the first vertex of the circle that the loop is sewn to.
  [[nodiscard]] Loop baseLoop(bool top, double start) const {
    Loop loop;
    const std::vector<double>& turns = top ? m_pattern.topTurns : m_pattern.bottomTurns;
    for (Index k = 0; k < m_teeth; ++k) {
      for (std::size_t b = 0; b < m_pattern.base.size(); ++b) {
        loop.vertices.push_back(faceStart(top) + (k * m_faces + m_pattern.base[b]) % (m_teeth * m_faces));
        loop.angles.push_back(2 * pi * k / m_teeth + m_pattern.baseAngles[b] + turns[b]);
      }
    }
    if (turns.front() != 0) beginLoopAt(loop, start);
    return loop;
  }

 private:
  [[nodiscard]] Index faceStart(bool top) const {
    return m_teeth * (m_layers * m_walls + (top ? m_faces : 0));
  }
  void writeVertices();
  void writeTriangles();

  Index m_teeth, m_walls = 0, m_faces = 0, m_layers = 2;
  bool m_inward;
  const ToothPattern& m_pattern;
  Solid& m_solid;
};

void ToothedShell::writeVertices() {
  std::vector<Turn> turns;
  for (Index k = 0; k < m_teeth; ++k) {
    const double angle = 2 * pi * k / m_teeth;
    turns.push_back({std::cos(angle), std::sin(angle)});
  }
  Float3* positions = m_solid.positions.data();
  Float3* normals = m_solid.normals.data();
  const std::size_t wallAll = std::size_t{m_teeth} * m_walls;
  for (std::size_t layer = 0; layer < m_pattern.walls.size(); ++layer)
    repeat(m_pattern.walls[layer], turns, positions + layer * wallAll, normals + layer * wallAll);
  for (const bool top : {false, true}) {
    const std::size_t start = faceStart(top);
    repeat(top ? m_pattern.faceTop : m_pattern.faceBottom, turns, nullptr, normals + start);
    const Float3* wall = positions + (top ? (m_layers - 1) * wallAll : 0);
    Float3* face = positions + start;
    for (Index k = 0; k < m_teeth; ++k) {
      for (const Index at : m_pattern.wallOfFace) *face++ = wall[k * m_walls + at];
    }
  }
}

void ToothedShell::writeTriangles() {
  Triangle* out = m_solid.triangles.data();
  const Index wallAll = m_teeth * m_walls;
  const Index faceAll = m_teeth * m_faces;
  const std::size_t second = m_inward ? 2 : 1;  // rings turn every triangle over
  const std::size_t third = 3 - second;
  const auto write = [&](Index a, Index b, Index c) {
    (*out)[0] = a;
    (*out)[second] = b;
    (*out)[third] = c;
    ++out;
  };
  for (Index k = 0; k < m_teeth; ++k) {
    for (Index layer = 0; layer < m_layers; ++layer) {
      if (m_pattern.isEdge[layer] != 0) continue;
      const Index below = layer * wallAll;
      for (const auto& [from, to] : m_pattern.wallEdges) {
        const Index a = below + k * m_walls + from;
        const Index next = k * m_walls + to;
        const Index b = below + (next == wallAll ? 0 : next);
        write(a, b, wallAll + b);
        write(a, wallAll + b, wallAll + a);
      }
    }
    for (const Triangle& t : m_pattern.faceTriangles) {
      Index v[3];
      for (std::size_t i = 0; i < 3; ++i) {
        const Index local = k * m_faces + t[i];
        v[i] = local >= faceAll ? local - faceAll : local;
      }
      write(faceStart(true) + v[0], faceStart(true) + v[1], faceStart(true) + v[2]);
      write(faceStart(false) + v[0], faceStart(false) + v[2], faceStart(false) + v[1]);
    }
  }
}

/// The strips of the body; where it has windows, those of the web have openings.
void addBody(ShellBuilder& builder, const BodyBelow& below, int count, double start) {
  if (!below.windows) {
    builder.addRevolved(below.body, count, start);
    return;
  }
  const WebWindows& w = *below.windows;
  const std::vector<ProfileVertex>& body = below.body;
  const auto isWeb = [&](const ProfileVertex& a, const ProfileVertex& b) {
    const bool top = a == ProfileVertex{w.rim, w.half} && b == ProfileVertex{w.hub, w.half};
    return top || (a == ProfileVertex{w.hub, -w.half} && b == ProfileVertex{w.rim, -w.half});
  };
  for (std::size_t i = 0; i + 1 < body.size(); ++i) {
    if (!isWeb(body[i], body[i + 1])) builder.addRevolved(std::span(body).subspan(i, 2), count, start);
  }
  addWindowedWeb(builder, w, count, start, below.tolerance);
}

}  // namespace

int circleCountOf(const BodyBelow& below) {
  double largest = 0;
  for (const ProfileVertex& c : below.body) largest = std::max(largest, c.radius);
  int count = circleCount(largest, below.tolerance);
  if (below.windows) count += (below.windows->count - count % below.windows->count) % below.windows->count;
  return count;
}

void sewBodyBelow(ShellBuilder& builder, const BodyBelow& below, int count, double start, const FaceLoop& top,
                  const FaceLoop& bottom) {
  builder.sew(top.loop, builder.addCircle(below.body.front(), count, start, top.normal));
  addBody(builder, below, count, start);
  builder.sew(builder.addCircle(below.body.back(), count, start, bottom.normal), bottom.loop);
}

Solid meshed(const GearBlank& blank) {
  GEARGRAPH_REQUIRE(blank.teeth >= 3 && blank.below.body.size() >= 2);
  Solid solid;
  const ToothPattern pattern(blank);
  const int count = circleCountOf(blank.below);
  const ToothedShell teeth(blank, pattern, static_cast<std::size_t>(count), solid);
  ShellBuilder builder(solid, blank.inward);
  const double start = -pi / blank.teeth;
  // The faces go on below the teeth with the normal they have in the middle of the tooth, where y = 0.
  const Vector3d& up = blank.half.back().topNormal;
  const Vector3d& down = blank.half.back().bottomNormal;
  sewBodyBelow(builder, blank.below, count, start, {teeth.baseLoop(true, start), {up.x(), up.z()}},
               {teeth.baseLoop(false, start), {down.x(), down.z()}});
  return solid;
}

}  // namespace geargraph
