#include <algorithm>
#include <cmath>

#include "core/presentation/diagrams/band_marks.h"
#include "core/presentation/diagrams/power_drawing.h"
#include "core/presentation/diagrams/power_legend.h"
#include "core/presentation/drawing/digraph_drawing.h"

namespace geargraph {
namespace {

class DigraphBands {
 public:
  DigraphBands(const PowerPicture& picture, const Mechanism& mechanism, const DigraphGeometry& geometry)
      : m_mechanism(mechanism), m_geometry(geometry), m_painter(picture, digraphDrawing(geometry, {})) {
    for (const DrawnFlow& flow : picture.flows) add(flow);
  }

  DisplayList finish() && { return std::move(m_painter).finish(); }

 private:
  void add(const DrawnFlow& flow) {
    if (const EdgePlace* edge = m_geometry.edge(flow.element)) return addEdge(flow, *edge);
    if (flow.element.kind == ElementKind::coupling) return addCoupling(flow);
    if (flow.element.kind == ElementKind::link) addAtLink(flow);
  }

  [[nodiscard]] Tint tintOf(const DrawnFlow& flow) const { return tintOfFlow(flow, m_mechanism); }
  static const DrawnPort* portAt(const DrawnFlow& flow, LinkOrdinal link) {
    for (const DrawnPort& port : flow.ports)
      if (port.link == link) return &port;
    return nullptr;
  }

  /// A band along a course, with the power in its direction; against it where that is negative.
  void addBand(const DrawnFlow& flow, std::vector<CanvasPoint> course, double power, double circulating,
               bool hasLabel = true) {
    if (power == 0) return;
    if (power < 0) std::reverse(course.begin(), course.end());
    m_painter.add(Band{flow.element, std::move(course), tintOf(flow), std::abs(power), std::abs(circulating),
                       flow.isDetermined, hasLabel, flow.isAssumed});
  }

  void addEdge(const DrawnFlow& flow, const EdgePlace& edge) {
    if (!flow.isDetermined) {
      m_painter.add(Band{flow.element, courseOf(edge.curve), {}, 0, 0, false});
      return;
    }
    const DrawnPort* const tail = portAt(flow, edge.tail);
    const DrawnPort* const head = portAt(flow, edge.head);
    const double from = tail == nullptr ? 0 : -tail->power;
    const double to = head == nullptr ? 0 : head->power;
    const double fromLoop = tail == nullptr ? 0 : tail->circulating;
    const double toLoop = head == nullptr ? 0 : head->circulating;
    const bool isOne = std::abs(from - to) <= kAsOneFlow * std::max(std::abs(from), std::abs(to)) &&
                       (fromLoop == 0) == (toLoop == 0);
    const bool isMotor = !edge.isMesh() && (from == 0 || to == 0);  // the ground is at rest
    if (isOne || isMotor) {
      addBand(flow, courseOf(edge.curve), std::abs(from) > std::abs(to) ? from : to,
              std::max(std::abs(fromLoop), std::abs(toLoop)));
    } else {
      addBand(flow, courseOf(edge.curve.part(0, 0.5)), from, fromLoop);
      addBand(flow, courseOf(edge.curve.part(0.5, 1)), to, toLoop);
    }
    const CanvasPoint middle = edge.curve.at(0.5);
    for (const DrawnPort& port : flow.ports) {
      if (port.link == edge.tail || port.link == edge.head) continue;
      if (const NodePlace* carrier = nodeOf(port.link))
        addBand(flow, toRim(middle, carrier->center), port.power, port.circulating);
    }
    m_painter.add(LossStub{flow.element, middle, flow.lost});
  }

  [[nodiscard]] const NodePlace* nodeOf(LinkOrdinal link) const {
    return m_geometry.node(m_mechanism.links[link].id);
  }
  static std::vector<CanvasPoint> toRim(CanvasPoint from, CanvasPoint node) {
    const double rim = std::min(kNodeRadius, distance(from, node) / 2);
    return {from, node - rim * unit(node - from)};
  }

  void addCoupling(const DrawnFlow& flow) {
    const auto place =
        std::find_if(m_geometry.couplings.begin(), m_geometry.couplings.end(),
                     [&](const ShiftElementPlace& each) { return ElementId(each.coupling) == flow.element; });
    if (place == m_geometry.couplings.end() || flow.ports.size() < 2) return;
    addBand(flow, courseOf(place->line), flow.ports[1].power, flow.ports[1].circulating);
  }

  /// A load or a balance on a link: from outside into its node, or out of it, where there is most room.
  void addAtLink(const DrawnFlow& flow) {
    constexpr double kLength = 40;
    constexpr int kDirections = 16;
    const NodePlace* const node = nodeOf(flow.ports.front().link);
    if (node == nullptr) return;
    CanvasPoint best{0, -1};
    double most = -1;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * M_PI * i / kDirections;
      const CanvasPoint way{std::cos(angle), std::sin(angle)};
      const double room = roomAt(node->center + (kNodeRadius + kLength / 2) * way, *node);
      if (room <= most) continue;
      most = room;
      best = way;
    }
    const CanvasPoint rim = node->center + kNodeRadius * best;
    addBand(flow, {rim + kLength * best, rim}, flow.ports.front().power, 0);
  }

  [[nodiscard]] double roomAt(CanvasPoint place, const NodePlace& without) const {
    double room = 1e9;
    for (const NodePlace& node : m_geometry.nodes)
      if (node.link != without.link) room = std::min(room, distance(place, node.center) - kNodeRadius);
    for (const EdgePlace& edge : m_geometry.edges) room = std::min(room, distanceToCurve(place, edge.curve));
    return room;
  }

  const Mechanism& m_mechanism;
  const DigraphGeometry& m_geometry;
  BandPainter m_painter;
};

}  // namespace

DisplayList digraphPower(const PowerPicture& picture, const Mechanism& mechanism,
                         const DigraphGeometry& geometry) {
  if (picture.isEmpty()) return {};
  return DigraphBands(picture, mechanism, geometry).finish();
}

}  // namespace geargraph
