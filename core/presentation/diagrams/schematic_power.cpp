#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/diagrams/band_marks.h"
#include "core/presentation/diagrams/band_network.h"
#include "core/presentation/diagrams/power_drawing.h"

namespace geargraph {
namespace {

constexpr double kOutside = 44;    ///< px: the band of a motor or a load beyond the end of its shaft
constexpr double kShaftEnds = 60;  ///< px from a bearing: the end of a shaft where power enters it

/// What all flows that are drawn at one element carry together: equal planets share one drawing.
struct Joined {
  std::map<int, DrawnPort> ports;  ///< by link that is drawn
  std::vector<double> members;     ///< by self-stress, the sum over all meshes
  double lost = 0;
  bool isDetermined = true;
  bool isAssumed = false;

  void add(const DrawnFlow& flow) {
    lost += flow.lost;
    members.resize(std::max(members.size(), flow.members.size()));
    for (std::size_t i = 0; i < flow.members.size(); ++i) members[i] += flow.members[i];
    if (!flow.isDetermined && flow.members.empty()) isDetermined = false;
    isAssumed = isAssumed || (flow.isAssumed && flow.members.empty());
    m_isByStiffness = m_isByStiffness || flow.isAssumed;
  }
  /// Together they bear a known load where no self-stress changes it.
  void conclude() {
    constexpr double kRounding = 1e-9;
    for (const double member : members) {
      if (std::abs(member) <= kRounding) continue;
      if (m_isByStiffness) isAssumed = true;
      if (!m_isByStiffness) isDetermined = false;
    }
  }

 private:
  bool m_isByStiffness = false;
};

class SchematicBands {
 public:
  SchematicBands(const PowerPicture& picture, const Mechanism& mechanism, const SchematicGeometry& geometry)
      : m_picture(picture),
        m_mechanism(mechanism),
        m_geometry(geometry),
        m_painter(picture, schematicDrawing(geometry, {})),
        m_networks(mechanism.links.size()),
        m_entries(mechanism.links.size()) {
    for (std::size_t i = 0; i < mechanism.links.size(); ++i)
      m_links[mechanism.links[i].id] = static_cast<int>(i);
    for (const DrawnPart::Represented& represented : geometry.represented)
      m_drawnAs[represented.omitted] = represented.drawn;
    readMarks();
    joinFlows();
  }

  DisplayList run() && {
    for (const auto& [element, flow] : m_joined) add(element, flow);
    for (std::size_t link = 1; link < m_networks.size(); ++link) addRuns(static_cast<int>(link));
    // Where the link itself carries unknown parts, what enters or leaves it has the label.
    for (auto& [link, band] : m_outside) {
      band.hasLabel = carriesUnknown(link);
      m_painter.add(std::move(band));
    }
    return std::move(m_painter).finish();
  }

 private:
  [[nodiscard]] ElementId drawn(const ElementId& element) const {
    const auto found = m_drawnAs.find(element);
    return found == m_drawnAs.end() ? element : found->second;
  }
  [[nodiscard]] LinkOrdinal drawnLink(LinkOrdinal link) const {
    const auto found = m_links.find(drawn(m_mechanism.links[link].id));
    return found == m_links.end() ? link
                                  : LinkOrdinal(found->second);  // a drawing of the document as it was before
  }
  [[nodiscard]] Tint tintOf(LinkOrdinal link) const {
    return Tint::ofLink(m_mechanism.linkLabel(link), m_mechanism.colorNumber(link));
  }
  [[nodiscard]] BandNetwork& network(LinkOrdinal link) { return m_networks[link]; }

  /// The lines of each link, and where bearings, meshes and couplings are.
  void readMarks() {
    std::unordered_map<int, int> byLabel;
    for (LinkOrdinal link = 0; link < static_cast<int>(m_mechanism.links.size()); ++link)
      byLabel[m_mechanism.linkLabel(link)] = link;
    for (const Mark& mark : m_geometry.marks) {
      const auto* stroke = std::get_if<Stroke>(&mark.what);
      if (stroke == nullptr || mark.role != MarkRole::line) continue;
      const auto* line = std::get_if<Polyline>(&stroke->shape);
      if (line == nullptr || line->points.size() < 2) {
        if (const auto* bow = std::get_if<Curve>(&stroke->shape))
          m_places.try_emplace(mark.element, std::vector<CanvasPoint>{bow->from, bow->to});
        continue;
      }
      if (mark.element.kind == ElementKind::turningJoint || mark.element.kind == ElementKind::coupling)
        m_places.try_emplace(
            mark.element, std::vector<CanvasPoint>{between(line->points.front(), line->points.back(), 0.5)});
      if (!stroke->tint.link) continue;
      const auto owner = byLabel.find(*stroke->tint.link);
      if (owner == byLabel.end()) continue;
      for (std::size_t i = 1; i < line->points.size(); ++i)
        network(owner->second).addLine(line->points[i - 1], line->points[i]);
    }
    for (const Mark& mark : m_geometry.highlights) {
      const auto* stroke = std::get_if<Stroke>(&mark.what);
      const auto* line = stroke == nullptr ? nullptr : std::get_if<Polyline>(&stroke->shape);
      if (line != nullptr && mark.element.kind == ElementKind::gearMesh)
        m_places.try_emplace(
            mark.element, std::vector<CanvasPoint>{between(line->points.front(), line->points.back(), 0.5)});
    }
  }

  void joinFlows() {
    for (const DrawnFlow& flow : m_picture.flows) {
      const bool isOnLink = flow.element.kind == ElementKind::link;
      Joined& joined = m_joined[{drawn(flow.element), isOnLink ? ++m_onLinks : 0}];
      joined.add(flow);
      for (const DrawnPort& port : flow.ports) {
        DrawnPort& sum = joined.ports[drawnLink(port.link)];
        sum.power += port.power;
        sum.circulating += port.circulating;
      }
    }
    for (auto& [key, joined] : m_joined) joined.conclude();
  }

  using Key = std::pair<ElementId, int>;

  void add(const Key& key, const Joined& flow) {
    const ElementId& element = key.first;
    switch (element.kind) {
      case ElementKind::gearMesh:
        return addMesh(element, flow);
      case ElementKind::coupling:
        return addCoupling(element, flow);
      case ElementKind::turningJoint:
        return addJoint(element, flow);
      case ElementKind::link:
        return addOnLink(flow);
      default:
        return;
    }
  }

  void enter(LinkOrdinal link, CanvasPoint at, const DrawnPort& port, const Joined& flow) {
    m_entries[link].push_back({at, port.power, port.circulating});
    if (!flow.isDetermined) m_unknown.push_back(link);
    if (flow.isAssumed) m_assumed.push_back(link);
  }

  /// Both gears at the pitch point, the carrier by a band of its own from there.
  void addMesh(const ElementId& element, const Joined& flow) {
    const auto place = m_places.find(element);
    const GearMesh* const mesh = m_mechanism.find(MeshId(element.id));
    if (place == m_places.end() || mesh == nullptr) return;
    const int tail = drawnLink(m_links.at(ElementId(mesh->tail)));
    const int head = drawnLink(m_links.at(ElementId(mesh->head)));
    const std::vector<CanvasPoint>& ends = place->second;
    for (const auto& [link, port] : flow.ports) {
      if (link == 0 || network(link).isEmpty()) continue;
      const CanvasPoint from = link == tail ? ends.front() : ends.back();
      const CanvasPoint at = network(link).nearest(from);
      enter(link, at, port, flow);
      if (link != tail && link != head) addToCarrier(element, from, at, flow, port);
    }
    if (flow.isDetermined) m_painter.add(LossStub{element, ends.front(), flow.lost});
  }

  /// What the mesh delivers to its carrier, bent away from the gears.
  void addToCarrier(const ElementId& element, CanvasPoint from, CanvasPoint to, const Joined& flow,
                    const DrawnPort& port) {
    if (distance(from, to) < 2) return;
    const double pull = std::min(30.0, distance(from, to) / 4);
    std::vector<CanvasPoint> course = courseOf(Curve::pulled(from, to, pull, pull));
    if (port.power < 0) std::reverse(course.begin(), course.end());
    m_painter.add(Band{element, std::move(course), tintOf(delivererOf(flow)), std::abs(port.power),
                       std::abs(port.circulating), flow.isDetermined, true, flow.isAssumed});
  }

  static int delivererOf(const Joined& flow) {
    const auto least =
        std::min_element(flow.ports.begin(), flow.ports.end(),
                         [](const auto& a, const auto& b) { return a.second.power < b.second.power; });
    return least->first;
  }

  void addCoupling(const ElementId& element, const Joined& flow) {
    const auto place = m_places.find(element);
    if (place == m_places.end()) return;
    for (const auto& [link, port] : flow.ports) {
      if (link == 0 || network(link).isEmpty()) continue;
      const CanvasPoint at = network(link).nearest(place->second.front());
      enter(link, at, port, flow);
      std::vector<CanvasPoint> course{place->second.front(), at};
      if (port.power < 0) std::reverse(course.begin(), course.end());
      m_painter.add(Band{element, std::move(course), tintOf(delivererOf(flow)), std::abs(port.power),
                         std::abs(port.circulating), flow.isDetermined, false, flow.isAssumed});
    }
  }

  /// Power of a motor or a load comes from beyond the end of the shaft, or goes there; what a joint passes on
  /// crosses at its bearing.
  void addJoint(const ElementId& element, const Joined& flow) {
    const auto place = m_places.find(element);
    if (place == m_places.end()) return;
    for (const auto& [link, port] : flow.ports) {
      if (link == 0 || network(link).isEmpty()) continue;
      if (flow.ports.size() == 1) {
        addFromOutside(element, link, place->second.front(), port, flow);
      } else {
        enter(link, network(link).nearest(place->second.front()), port, flow);
      }
    }
  }

  /// At the bearing in which the link turns, or where it is drawn.
  void addOnLink(const Joined& flow) {
    for (const auto& [link, port] : flow.ports) {
      if (link == 0 || network(link).isEmpty()) continue;
      const LinkId id = m_mechanism.links[link].id;
      for (const TurningJoint& joint : m_mechanism.turningJoints) {
        const auto place = m_places.find(joint.id);
        if ((joint.tail != id && joint.head != id) || place == m_places.end()) continue;
        addFromOutside(id, link, place->second.front(), port, flow);
        break;
      }
    }
  }

  void addFromOutside(const ElementId& element, LinkOrdinal link, CanvasPoint bearing, const DrawnPort& port,
                      const Joined& flow) {
    const CanvasPoint on = network(link).nearest(bearing);
    const CanvasPoint end = network(link).nearestEnd(bearing, kShaftEnds);
    const CanvasPoint way = distance(end, on) > 1 ? unit(end - on) : unit(on - bearing);
    enter(link, end, port, flow);
    std::vector<CanvasPoint> course{end + kOutside * way, end};
    if (port.power < 0) std::reverse(course.begin(), course.end());
    m_outside.emplace_back(link, Band{element, std::move(course), tintOf(link), std::abs(port.power), 0,
                                      flow.isDetermined, false, flow.isAssumed});
  }

  [[nodiscard]] bool carriesUnknown(LinkOrdinal link) const {
    return std::find(m_unknown.begin(), m_unknown.end(), link) != m_unknown.end();
  }

  void addRuns(LinkOrdinal link) {
    if (network(link).isEmpty()) return;
    const bool isKnown = !carriesUnknown(link);
    const bool isAssumed = std::find(m_assumed.begin(), m_assumed.end(), link) != m_assumed.end();
    const ElementId id = m_mechanism.links[link].id;
    for (BandNetwork::Run& run : network(link).runs(m_entries[link]))
      m_painter.add(Band{id, std::move(run.course), tintOf(link), run.power, std::max(0.0, run.circulating),
                         isKnown, true, isAssumed});
  }

  const PowerPicture& m_picture;
  const Mechanism& m_mechanism;
  const SchematicGeometry& m_geometry;
  BandPainter m_painter;
  std::unordered_map<ElementId, int> m_links;
  std::unordered_map<ElementId, ElementId> m_drawnAs;
  std::unordered_map<ElementId, std::vector<CanvasPoint>> m_places;  ///< pitch points, bearings, plates
  ByLink<BandNetwork> m_networks;
  ByLink<std::vector<BandNetwork::Entry>> m_entries;
  std::map<Key, Joined> m_joined;
  ByLink<std::pair<int, Band>> m_outside;  ///< of motors and loads
  std::vector<int> m_unknown;              ///< links that carry unknown parts of a load
  std::vector<int> m_assumed;              ///< links that carry parts decided by stiffness
  int m_onLinks = 0;
};

}  // namespace

DisplayList schematicPower(const PowerPicture& picture, const Mechanism& mechanism,
                           const SchematicGeometry& geometry) {
  if (picture.isEmpty() || geometry.isEmpty()) return {};
  return SchematicBands(picture, mechanism, geometry).run();
}

}  // namespace geargraph
