#include "core/design/atlas/chain_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <tuple>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/machine/body_layout/derived_geometry.h"

namespace geargraph {
namespace {

constexpr double kPolygonSide = 60;   ///< mm, between neighbouring axes of a link
constexpr double kMinApart = 20;      ///< mm, between axes that have no link in common
constexpr double kNodeSpacing = 110;  ///< of the digraph's nodes

AxisId documentAxis(std::size_t axis) {
  return AxisId(std::string(1, static_cast<char>('a' + static_cast<int>(axis))));
}

struct ChainPoint {
  double x = 0;
  double y = 0;
};

double distanceOf(const ChainPoint& a, const ChainPoint& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

ChainPoint beside(const ChainPoint& point, double distance, double angle) {
  return {point.x + distance * std::cos(angle), point.y + distance * std::sin(angle)};
}

Number hundredths(double value) {
  const auto whole = static_cast<std::int64_t>(std::llround(value * 100));
  return Number(Rational(whole, 100));
}

/// The tree of links and axes as seen from the frame, and where its axes are.
class AxisPolygons {
 public:
  AxisPolygons(const Chain& chain, int frame, double growth)
      : m_chain(chain),
        m_growth(growth),
        m_side(static_cast<std::size_t>(chain.links), kPolygonSide),
        m_points(chain.axes.size()),
        m_rootLink(chain.axes.size(), -1),
        m_rootAxis(static_cast<std::size_t>(chain.links), -1) {
    m_linkOrder.push_back(frame);
    for (std::size_t next = 0; next < m_linkOrder.size(); ++next) place(m_linkOrder[next]);
  }

  [[nodiscard]] const std::vector<ChainPoint>& points() const { return m_points; }
  /// By axis: its link nearest the frame.
  [[nodiscard]] int rootLink(std::size_t axis) const { return m_rootLink[axis]; }
  /// By link: its axis nearest the frame; -1 for the frame.
  [[nodiscard]] int rootAxis(int link) const { return m_rootAxis[static_cast<std::size_t>(link)]; }
  /// The id of a link in the document: its label there.
  [[nodiscard]] LinkId idOf(int link) const {
    const auto found = std::find(m_linkOrder.begin(), m_linkOrder.end(), link);
    return LinkId(std::to_string(found - m_linkOrder.begin()));
  }
  /// The frame, and each link after those nearer to it.
  [[nodiscard]] const std::vector<int>& linkOrder() const { return m_linkOrder; }

 private:
  /// Places the axes of a link that are farther from the frame, on a polygon with the one that is nearer.
  void place(int carrier) {
    std::vector<int> axes;
    if (rootAxis(carrier) >= 0) axes.push_back(rootAxis(carrier));
    for (int axis = 0; axis < static_cast<int>(m_chain.axes.size()); ++axis) {
      const std::vector<int>& links = m_chain.axes[static_cast<std::size_t>(axis)];
      if (axis != rootAxis(carrier) && std::find(links.begin(), links.end(), carrier) != links.end())
        axes.push_back(axis);
    }
    const std::size_t placed = rootAxis(carrier) >= 0 ? 1 : 0;
    if (axes.size() == placed) return;
    order(carrier, axes);
    turnToFreeSpace(carrier, axes, placed);
    for (std::size_t i = placed; i < axes.size(); ++i) {
      m_rootLink[static_cast<std::size_t>(axes[i])] = carrier;
      m_placed.push_back(axes[i]);
      for (const int link : m_chain.axes[static_cast<std::size_t>(axes[i])]) {
        if (link == carrier) continue;
        m_rootAxis[static_cast<std::size_t>(link)] = axes[i];
        m_linkOrder.push_back(link);
        m_side[static_cast<std::size_t>(link)] = m_side[static_cast<std::size_t>(carrier)] * m_growth;
      }
    }
    if (placed == 0) m_placed.push_back(axes.front());
  }

  /// The order round the polygon in which the axes that gear pairs connect are nearest; the first stays.
  void order(int carrier, std::vector<int>& axes) const {
    std::vector<std::pair<int, int>> pairs;
    const auto axisOf = [&](int link) {
      const auto found = std::find_if(axes.begin(), axes.end(), [&](int axis) {
        const std::vector<int>& links = m_chain.axes[static_cast<std::size_t>(axis)];
        return std::find(links.begin(), links.end(), link) != links.end();
      });
      return *found;
    };
    for (const ChainMesh& mesh : m_chain.meshes)
      if (mesh.carrier == carrier) pairs.emplace_back(axisOf(mesh.tail), axisOf(mesh.head));
    const auto length = [&](const std::vector<int>& round) {
      double sum = 0;
      for (const auto& [a, b] : pairs) {
        const auto steps =
            std::find(round.begin(), round.end(), a) - std::find(round.begin(), round.end(), b);
        sum += std::pow(
            std::sin(std::numbers::pi * static_cast<double>(steps) / static_cast<double>(round.size())), 2);
      }
      return sum;
    };
    std::vector<int> best = axes;
    std::vector<int> round = axes;
    std::sort(round.begin() + 1, round.end());
    do {
      if (length(round) < length(best) - 1e-9) best = round;
    } while (std::next_permutation(round.begin() + 1, round.end()));
    axes = best;
  }

  /// Away from the frame where the polygon comes near no axis that is there.
  void turnToFreeSpace(int carrier, const std::vector<int>& axes, std::size_t placed) {
    const ChainPoint corner = placed == 1 ? m_points[static_cast<std::size_t>(axes.front())] : ChainPoint();
    const double away = std::hypot(corner.x, corner.y) > 1 ? std::atan2(corner.y, corner.x) : 0;
    constexpr int kTurns = 24;
    for (int turn = 0; turn < kTurns; ++turn) {
      const int steps = turn % 2 == 0 ? turn / 2 : -(turn + 1) / 2;
      setPolygon(axes, corner, away + steps * 2 * std::numbers::pi / kTurns,
                 m_side[static_cast<std::size_t>(carrier)], placed);
      if (isClear(axes, placed)) return;
    }
  }

  void setPolygon(const std::vector<int>& axes, const ChainPoint& corner, double direction, double side,
                  std::size_t placed) {
    const auto count = static_cast<double>(axes.size());
    const double radius = axes.size() == 1 ? 0 : side / (2 * std::sin(std::numbers::pi / count));
    const ChainPoint centre = beside(corner, radius, direction);
    for (std::size_t i = placed; i < axes.size(); ++i) {
      const double angle =
          direction + std::numbers::pi + 2 * std::numbers::pi * static_cast<double>(i) / count;
      m_points[static_cast<std::size_t>(axes[i])] = beside(centre, radius, angle);
    }
  }

  [[nodiscard]] bool isClear(const std::vector<int>& axes, std::size_t placed) const {
    for (std::size_t i = placed; i < axes.size(); ++i) {
      for (const int other : m_placed) {
        if (distanceOf(m_points[static_cast<std::size_t>(axes[i])],
                       m_points[static_cast<std::size_t>(other)]) < kMinApart)
          return false;
      }
    }
    return true;
  }

  const Chain& m_chain;
  double m_growth;
  std::vector<double> m_side;  ///< by link: of the polygon of its axes, mm
  std::vector<ChainPoint> m_points;
  std::vector<int> m_rootLink;
  std::vector<int> m_rootAxis;
  std::vector<int> m_linkOrder;
  std::vector<int> m_placed;
};

/// Teeth of an external pair and of a pinion in a ring: neighbouring primes, different for each mesh.
constexpr std::array kExternalTeeth = {std::pair(23, 29), std::pair(31, 37), std::pair(41, 43),
                                       std::pair(47, 53), std::pair(59, 61), std::pair(67, 71),
                                       std::pair(73, 79)};
constexpr std::array kRingTeeth = {std::pair(19, 83),  std::pair(23, 97),  std::pair(29, 101),
                                   std::pair(31, 113), std::pair(37, 127), std::pair(41, 131),
                                   std::pair(43, 139)};

void addGearPair(const Chain& chain, const AxisPolygons& polygons, std::size_t position, bool isRing,
                 Mechanism& document) {
  const ChainMesh& mesh = chain.meshes[position];
  const auto addWheel = [&](int link, const char* end) {
    Wheel wheel;
    wheel.id = WheelId(std::to_string(position + 1) + end);
    wheel.link = polygons.idOf(link);
    document.wheels.push_back(wheel);
    return wheel.id;
  };
  GearMesh& drawn = document.gearMeshes.emplace_back();
  drawn.id = MeshId(std::to_string(2 * chain.links - 1 + static_cast<int>(position)));
  drawn.tail = polygons.idOf(mesh.tail);
  drawn.head = polygons.idOf(mesh.head);
  drawn.kind = isRing ? MeshKind::internal : MeshKind::external;
  const auto& teeth = isRing ? kRingTeeth : kExternalTeeth;
  std::tie(drawn.tailTeeth, drawn.headTeeth) = teeth[position % teeth.size()];
  // The ring turns on the carrier's axis towards the frame, or, of two outer axes, is the head.
  const bool isTailInner =
      polygons.rootAxis(mesh.carrier) >= 0 && polygons.rootAxis(mesh.tail) == polygons.rootAxis(mesh.carrier);
  if (isRing && isTailInner) std::swap(drawn.tailTeeth, drawn.headTeeth);
  drawn.tailWheel = addWheel(mesh.tail, "t");
  drawn.headWheel = addWheel(mesh.head, "h");
}

/// Nodes on a circle, in the order in which a walk over the tree of joints meets the links.
void addNodes(const Chain& chain, const AxisPolygons& polygons, Mechanism& document) {
  std::vector<int> walk;
  std::vector<int> open{polygons.linkOrder().front()};
  while (!open.empty()) {
    const int link = open.back();
    open.pop_back();
    walk.push_back(link);
    for (auto next = polygons.linkOrder().rbegin(); next != polygons.linkOrder().rend(); ++next) {
      const int axis = polygons.rootAxis(*next);
      if (axis >= 0 && polygons.rootLink(static_cast<std::size_t>(axis)) == link) open.push_back(*next);
    }
  }
  const double radius = kNodeSpacing / (2 * std::sin(std::numbers::pi / chain.links));
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const double angle = std::numbers::pi * (2.0 * static_cast<double>(i) / chain.links - 1);
    document.view.nodes[polygons.idOf(walk[i])] = {std::round(radius * std::cos(angle)),
                                                   std::round(radius * std::sin(angle))};
  }
}

/// The links, the usual frame first.
std::vector<int> framesInOrder(const Chain& chain) {
  std::vector<std::tuple<int, int, int, int>> ranks;
  for (int link = 0; link < chain.links; ++link) {
    int bundle = 0;
    for (const std::vector<int>& axis : chain.axes)
      if (std::find(axis.begin(), axis.end(), link) != axis.end())
        bundle = std::max(bundle, static_cast<int>(axis.size()));
    int carries = 0;
    int gears = 0;
    for (const ChainMesh& mesh : chain.meshes) {
      carries = mesh.carrier == link ? 1 : carries;
      gears += mesh.tail == link || mesh.head == link ? 1 : 0;
    }
    ranks.emplace_back(-bundle, carries, gears, link);
  }
  std::sort(ranks.begin(), ranks.end());
  std::vector<int> frames;
  for (const auto& rank : ranks) frames.push_back(std::get<3>(rank));
  return frames;
}

/// The document with this frame. `growth`: of the sides of polygons from one link to the next outer one.
Mechanism documentOf(const Chain& chain, const std::string& name, int frame, const std::vector<int>& rings,
                     double growth) {
  const AxisPolygons polygons(chain, frame, growth);
  Mechanism document = emptyMechanism();
  document.name = std::move(name);
  document.links.clear();
  document.view.nodes.clear();
  for (std::size_t a = 0; a < chain.axes.size(); ++a) {
    const ChainPoint& point = polygons.points()[a];
    document.axes.push_back({documentAxis(a),
                             NumberTriple{hundredths(point.x), hundredths(point.y), Number(0)},
                             NumberTriple{Number(0), Number(0), Number(1)},
                             {}});
  }
  for (const int link : polygons.linkOrder()) {
    document.links.push_back(
        {polygons.idOf(link), translated("link %1 of the chain", {std::to_string(link + 1)}), {}});
    const int axis = polygons.rootAxis(link);
    if (axis < 0) continue;
    const auto position = static_cast<std::size_t>(axis);
    document.turningJoints.push_back({JointId(std::to_string(chain.links + document.t())),
                                      polygons.idOf(polygons.rootLink(position)),
                                      polygons.idOf(link),
                                      documentAxis(position),
                                      Number(0),
                                      {}});
  }
  for (std::size_t m = 0; m < chain.meshes.size(); ++m) {
    const bool isRing = std::find(rings.begin(), rings.end(), static_cast<int>(m)) != rings.end();
    addGearPair(chain, polygons, m, isRing, document);
  }
  addNodes(chain, polygons, document);
  return document;
}

}  // namespace

int usualFrame(const Chain& chain) {
  return framesInOrder(chain).front();
}

Mechanism chainDocument(const Chain& chain, std::string name, const ChainDrawing& drawing,
                        const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(chain.axes.size() <= 26);
  GEARGRAPH_REQUIRE(!drawing.frame || (*drawing.frame >= 0 && *drawing.frame < chain.links));
  std::optional<Mechanism> best;
  std::size_t fewest = 0;
  for (const int frame : drawing.frame ? std::vector<int>{*drawing.frame} : framesInOrder(chain)) {
    for (const double growth : {1.0, 0.55, 1.7, 0.4, 1.3, 0.7, 0.85, 2.2}) {
      Mechanism document = documentOf(chain, name, frame, drawing.rings, growth);
      const auto found = DerivedGeometry(PlacedMechanism(document)).diagnostics(stop);
      const std::size_t count = found ? found->size() : 0;
      if (!best || (found && count < fewest)) {
        best = std::move(document);
        fewest = count;
      }
      if (stop.stop_requested() || fewest == 0) return *std::move(best);
    }
  }
  return *std::move(best);
}

}  // namespace geargraph
