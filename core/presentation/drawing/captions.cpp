#include "core/presentation/drawing/captions.h"

#include <array>
#include <map>
#include <optional>

#include "core/presentation/drawing/digraph_geometry.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/drawing/obstacle_grid.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

constexpr std::size_t kMostCharacters = 18;
constexpr double kFree = 2;                ///< px that a caption keeps from everything
constexpr double kTeethShare = 11.0 / 12;  ///< size of teeth to that of the number of the mesh

/// The room of a label: a link's disc or the number of a mesh.
struct Anchor {
  ElementId element;
  Extent box;
  double size = 0;  ///< px of its text
};

class ObstacleAdder {
 public:
  explicit ObstacleAdder(ObstacleGrid& grid) : m_grid(grid) {}

  void add(const Mark& mark) {
    if (mark.role == MarkRole::halo || mark.role == MarkRole::preview) return;
    if (const auto* stroke = std::get_if<Stroke>(&mark.what)) return addShape(stroke->shape);
    if (const auto* fill = std::get_if<Fill>(&mark.what)) return addShape(fill->shape);
    m_grid.addBox(extentOf(mark));
  }

 private:
  void addShape(const Shape& shape) {
    if (const auto* circle = std::get_if<Circle>(&shape)) {
      m_grid.addCircle(circle->center, circle->radius, 0);
    } else if (const auto* box = std::get_if<Box>(&shape)) {
      m_grid.addBox(box->extent);
    } else if (const auto* curve = std::get_if<Curve>(&shape)) {
      m_grid.addCurve(*curve);
    } else {
      const auto& line = std::get<Polyline>(shape);
      for (std::size_t i = 1; i < line.points.size(); ++i)
        m_grid.addCurve(Curve::straight(line.points[i - 1], line.points[i]));
      if (line.closed && line.points.size() > 2)
        m_grid.addCurve(Curve::straight(line.points.back(), line.points.front()));
    }
  }

  ObstacleGrid& m_grid;
};

/// A free place for a text beside a box: below, above, beside it, at its corners, then a little farther out.
std::optional<Extent> placeAt(const Extent& box, double halfWidth, double halfHeight,
                              const ObstacleGrid& taken) {
  constexpr std::array kGaps{3.0, 6.0, 10.0};
  constexpr std::array<CanvasPoint, 12> kWays{{{0, 1},
                                               {0, -1},
                                               {1, 0},
                                               {-1, 0},
                                               {1, 1},
                                               {1, -1},
                                               {-1, 1},
                                               {-1, -1},
                                               {0.5, 1},
                                               {-0.5, 1},
                                               {0.5, -1},
                                               {-0.5, -1}}};
  for (const double gap : kGaps) {
    for (const CanvasPoint way : kWays) {
      // At a corner the text begins beside the box, half its height above or below the middle.
      const bool isCorner = std::abs(way.x) == 1 && way.y != 0;
      const double x = way.x * (std::abs(way.x) == 1 ? box.halfWidth + gap + halfWidth : halfWidth);
      const double y = way.y * (isCorner     ? box.halfHeight
                                : way.y == 0 ? 0
                                             : box.halfHeight + gap + halfHeight);
      const Extent place{box.center + CanvasPoint{x, y}, halfWidth, halfHeight};
      if (!taken.touches(place, kFree)) return place;
    }
  }
  return std::nullopt;
}

class Captioner {
 public:
  Captioner(const DisplayList& drawing, const Mechanism& mechanism, double nameSize)
      : m_mechanism(mechanism), m_nameSize(nameSize), m_taken(extentOf(drawing).grown(80)) {
    ObstacleAdder obstacles(m_taken);
    for (const Mark& mark : drawing.marks) obstacles.add(mark);
    collect(drawing);
  }

  std::vector<Mark> run() {
    for (int link = 0; link <= m_mechanism.n(); ++link) addName(link);
    for (const GearMesh& mesh : m_mechanism.gearMeshes) addTeeth(mesh);
    return std::move(m_marks);
  }

 private:
  void collect(const DisplayList& drawing) {
    for (const Mark& mark : drawing.marks) {
      const auto* text = std::get_if<Text>(&mark.what);
      if (mark.role != MarkRole::label || text == nullptr) continue;
      const Anchor anchor{mark.element, extentOf(mark), text->size};
      if (mark.element.kind == ElementKind::gearMesh) m_meshes[mark.element].push_back(anchor);
      if (mark.element.kind == ElementKind::link) m_discs.insert_or_assign(mark.element, anchor);
    }
    for (const Mark& mark : drawing.marks) {
      const auto disc = m_discs.find(mark.element);
      if (mark.role != MarkRole::node || disc == m_discs.end()) continue;
      const Extent extent = extentOf(mark);
      if (extent.contains(disc->second.box)) disc->second.box = extent;
    }
  }

  void addName(int link) {
    const Link& named = m_mechanism.links[static_cast<std::size_t>(link)];
    const auto disc = m_discs.find(named.id);
    const bool isNumber = named.name == std::to_string(m_mechanism.linkLabel(link));
    if (disc == m_discs.end() || named.name.empty() || isNumber) return;
    const double size = m_nameSize > 0 ? m_nameSize : disc->second.size;
    put(named.id, elided(named.name, kMostCharacters), disc->second.box, size, ColorRole::ink);
  }

  void addTeeth(const GearMesh& mesh) {
    const auto labels = m_meshes.find(mesh.id);
    if (labels == m_meshes.end() || !statesTeeth(mesh)) return;
    const std::vector<Anchor>& anchors = labels->second;
    const std::string tail = std::to_string(mesh.tailTeeth);
    const std::string head = std::to_string(mesh.headTeeth);
    const auto at = [&](const Anchor& anchor, const std::string& teeth) {
      put(mesh.id, "z " + teeth, anchor.box, kTeethShare * anchor.size, ColorRole::secondary);
    };
    if (anchors.size() == 2) {
      at(anchors[0], tail);
      at(anchors[1], head);
    } else {
      at(anchors[0], tail + " : " + head);
    }
  }

  void put(const ElementId& element, const std::string& text, const Extent& beside, double size,
           ColorRole ink) {
    const double halfWidth = textWidth(text, size, false) / 2;
    const std::optional<Extent> place = placeAt(beside, halfWidth, 0.55 * size, m_taken);
    if (!place) return;
    m_taken.addBox(*place);
    m_marks.push_back({element, MarkRole::name, kCaptionDepth, Text{text, place->center, size, false, ink}});
  }

  static constexpr int kCaptionDepth = kLabelDepth;

  const Mechanism& m_mechanism;
  double m_nameSize;
  ObstacleGrid m_taken;
  std::map<ElementId, Anchor> m_discs;
  std::map<ElementId, std::vector<Anchor>> m_meshes;
  std::vector<Mark> m_marks;
};

}  // namespace

std::vector<Mark> captionsOf(const DisplayList& drawing, const Mechanism& mechanism, double nameSize) {
  if (drawing.marks.empty() || mechanism.n() > kMaxCaptionedLinks) return {};
  return Captioner(drawing, mechanism, nameSize).run();
}

DisplayList withCaptions(DisplayList drawing, const Mechanism& mechanism, double nameSize) {
  std::vector<Mark> captions = captionsOf(drawing, mechanism, nameSize);
  drawing.marks.insert(drawing.marks.end(), captions.begin(), captions.end());
  drawing.sortByDepth();
  return drawing;
}

}  // namespace geargraph
