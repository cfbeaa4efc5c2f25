#include "core/presentation/diagrams/chain_drawing.h"

#include <cmath>
#include <string>
#include <utility>

#include "core/presentation/diagrams/chain_layout.h"
#include "core/presentation/drawing/emphasis.h"

namespace geargraph {
namespace {

constexpr double kChainDiscRadius = 18;
constexpr double kDiscRing = 3.5;
constexpr double kTurningLine = 2.5;
constexpr double kPairLine = 2;
constexpr double kDiscText = 18;
constexpr double kAxisText = 16;
constexpr double kAxisDistance = 12;  ///< of a letter from its line

class ChainMarks {
 public:
  ChainMarks(const Chain& chain, const ChainDrawingStyle& style)
      : m_chain(chain), m_style(style), m_places(chainLayout(chain).places) {}

  [[nodiscard]] DisplayList drawn() {
    int joint = 0;
    for (const DrawnTurning& turning : drawnTurnings(m_chain)) {
      const ElementId id = JointId("j" + std::to_string(++joint));
      addLine(id, turning.links.first, turning.links.second, kTurningLine, Dash::solid);
      if (m_style.namesAxes) addAxisName(id, turning);
    }
    int pair = 0;
    for (const ChainMesh& mesh : m_chain.meshes)
      addLine(MeshId("m" + std::to_string(++pair)), mesh.tail, mesh.head, kPairLine, Dash::dashed);
    for (int link = 0; link < m_chain.links; ++link) addDisc(link);
    return std::move(m_list);
  }

 private:
  void add(const ElementId& id, MarkRole role, int z, std::variant<Stroke, Fill, Text> what) {
    m_list.marks.push_back({id, role, z, std::move(what)});
  }
  [[nodiscard]] CanvasPoint at(int link) const { return m_places[static_cast<std::size_t>(link)]; }

  void addLine(const ElementId& id, int from, int to, double width, Dash dash) {
    const Polyline line{{at(from), at(to)}, false};
    add(id, MarkRole::line, kLineDepth, Stroke{line, ColorRole::ink, width, dash});
    m_list.outlines.push_back({id, kLineDepth, line, width});
  }

  /// Beside the middle of its line, on the side that looks away from the middle of the drawing.
  void addAxisName(const ElementId& id, const DrawnTurning& turning) {
    const CanvasPoint a = at(turning.links.first);
    const CanvasPoint b = at(turning.links.second);
    const CanvasPoint middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    CanvasPoint out{(b.y - a.y) / length, (a.x - b.x) / length};
    if (out.x * middle.x + out.y * middle.y < 0) out = {-out.x, -out.y};
    const std::string letter(1, static_cast<char>('a' + turning.axis));
    add(id, MarkRole::label, kLabelDepth,
        Text{letter,
             {middle.x + kAxisDistance * out.x, middle.y + kAxisDistance * out.y},
             kAxisText,
             false,
             ColorRole::secondary});
  }

  void addDisc(int link) {
    const auto index = static_cast<std::size_t>(link);
    const int label = m_style.labels.empty() ? link + 1 : m_style.labels[index];
    const int color = m_style.colors.empty() ? link + 1 : m_style.colors[index];
    const ElementId id = LinkId(std::to_string(link + 1));
    const Circle disc{at(link), kChainDiscRadius};
    add(id, MarkRole::node, kNodeDepth, Fill{disc, ColorRole::sheet});
    add(id, MarkRole::node, kNodeDepth, Stroke{disc, Tint::ofLink(label, color), kDiscRing, Dash::solid});
    add(id, MarkRole::label, kNodeDepth,
        Text{std::to_string(label), at(link), label < 100 ? kDiscText : kDiscText - 4, true, ColorRole::ink});
    Outline& outline = m_list.outlines.emplace_back();
    outline.element = id;
    outline.z = kNodeDepth;
    outline.shape = disc;
  }

  const Chain& m_chain;
  const ChainDrawingStyle& m_style;
  std::vector<CanvasPoint> m_places;
  DisplayList m_list;
};

}  // namespace

DisplayList chainDrawing(const Chain& chain, const ChainDrawingStyle& style) {
  return ChainMarks(chain, style).drawn();
}

}  // namespace geargraph
