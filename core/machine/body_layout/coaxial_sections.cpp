#include "core/machine/body_layout/coaxial_sections.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

constexpr double kPitch = 3.6;      // modules: a disc with its clearance
constexpr double kNarrowest = 1.8;  // the same where there is little room
constexpr double kCell = 1.6;       // modules: the wall of a drum with its clearance
constexpr int kMaxSlots = 5;        // discs in a gap
constexpr int kMaxSleeves = 8;
constexpr double kMaxWidth = 1e4;  // modules: a way along a longer column costs no more
constexpr double kMaxRows = 2000;  // cells get higher where there would be more
constexpr double kMinRows = 50;
constexpr double kRunsOn = 30;  // what it costs to run on what is inside, without a bearing

class SectionMaker {
 public:
  SectionMaker(AxisGroupOrdinal axisGroup, SpanByClass<const AxisLayout> axes, const Placement& placement,
               const GearTrain& train, bool runOn)
      : m_class(axisGroup),
        m_axes(axes),
        m_placement(placement),
        m_train(train),
        m_axis(axes[axisGroup]),
        m_runOn(runOn) {
    m_made.module = m_axis.module;
    m_made.cell = kCell * m_axis.module;
  }

  CoaxialSections make() {
    findWheels();
    cutColumns();
    cutRows();
    for (const CoaxialPlanets& p : m_made.planets) blockPlanets(p);
    for (const Wheel& wheel : m_beside) blockBeside(wheel);
    makeNets();
    return std::move(m_made);
  }

 private:
  /// A wheel on the axis, or on a fixed one beside it.
  struct Wheel {
    GearOrdinal gear = 0;
    Interval span;
    double distance = 0;
  };
  void findWheels();
  /// Does the gear run in a ring of this axis?
  [[nodiscard]] bool meshesInside(GearOrdinal gear) const {
    const auto isOwnRing = [&](GearOrdinal g) {
      const TrainGear& other = m_train.gears[g];
      return other.axisGroup == m_class && isRing(other.spec);
    };
    return std::any_of(m_train.meshes.begin(), m_train.meshes.end(), [&](const TrainMesh& mesh) {
      return (mesh.tailGear == gear && isOwnRing(mesh.headGear)) ||
             (mesh.headGear == gear && isOwnRing(mesh.tailGear));
    });
  }
  void cutColumns();
  void addSlots(double low, double high);
  void cutRows();
  void blockPlanets(const CoaxialPlanets& planets);
  void blockBeside(const Wheel& wheel);
  void makeNets();
  void addWheel(const Wheel& wheel);
  void addCarried();
  void addHousing(NetOrdinal net);
  void addSupports(NetOrdinal net, bool onGround);
  [[nodiscard]] std::vector<RouteTerminal> pinTerminals(const CoaxialPlanets& planets) const;
  int netOf(LinkOrdinal link);

  [[nodiscard]] const GearSpec& spec(const Wheel& w) const { return m_train.gears[w.gear].spec; }
  [[nodiscard]] const GearSpec& planetSpec(const CoaxialPlanets& p) const;
  [[nodiscard]] Interval spanOf(const TrainGear& gear) const {
    const AxialSpan span = axialSpan(gear.spec);
    const double origin = m_axis.coordinate(gear.pose.translation());
    const double sense = gear.pose.linear().col(2).dot(m_axis.direction) < 0 ? -1 : 1;
    const double a = origin + sense * span.low, b = origin + sense * span.high;
    return {std::min(a, b), std::max(a, b), gear.link};
  }
  /// Columns that an interval covers.
  [[nodiscard]] std::pair<int, int> columnsOf(const Interval& s) const {
    int first = m_made.grid.columns, last = -1;
    for (int c = 0; c < m_made.grid.columns; ++c) {
      const double middle = (m_made.columns[c].low + m_made.columns[c].high) / 2;
      if (middle < s.low || middle > s.high) continue;
      first = std::min(first, c);
      last = c;
    }
    return {first, last};
  }
  template <class Mark>
  void forCells(const Interval& s, double from, double to, const Mark& mark) {
    const auto [first, last] = columnsOf(s);
    for (int c = first; c <= last; ++c) {
      for (int r = m_made.innerRows; r < m_made.grid.rows; ++r) {
        if (m_made.rowLow(r) < to && m_made.rowLow(r) + m_made.cell > from) mark(c, r);
      }
    }
  }
  void block(const Interval& s, double from, double to) {
    forCells(s, from, to,
             [&](int c, int r) { m_made.grid.owner[m_made.grid.cell(c, r)] = ProfileGrid::kBlocked; });
  }

  int m_class;
  SpanByClass<const AxisLayout> m_axes;
  const Placement& m_placement;
  const GearTrain& m_train;
  const AxisLayout& m_axis;
  bool m_runOn;
  CoaxialSections m_made;
  std::vector<Wheel> m_wheels, m_beside;
  std::map<int, double> m_planetTip;  ///< by axis class
  std::map<int, int> m_netOf;         ///< by link
};

void SectionMaker::findWheels() {
  const AxisGroups& classes = *m_placement.classes;
  std::map<int, CoaxialPlanets> planets;
  for (const GearOrdinal g : m_train.gears.ordinals()) {
    const TrainGear& gear = m_train.gears[g];
    const int c = gear.axisGroup;
    Wheel wheel{g, spanOf(gear), 0};
    if (c == m_class) {
      m_wheels.push_back(wheel);
      continue;
    }
    const AxisLayout& other = m_axes[c];
    if (other.direction.cross(m_axis.direction).norm() > 1e-6) continue;
    const Eigen::Vector3d apart = other.point - m_axis.point;
    wheel.distance = (apart - apart.dot(m_axis.direction) * m_axis.direction).norm();
    const LinkOrdinal rootLink = classes.classes[c].rootLink;
    const bool inRing = rootLink == 0 && meshesInside(g);  // the ground is a carrier, too
    if (classes.classOfLink(rootLink) != m_class && !inRing) {
      m_beside.push_back(wheel);
      continue;
    }
    CoaxialPlanets& p = planets.try_emplace(c, CoaxialPlanets{c, rootLink, wheel.distance, {}}).first->second;
    p.wheels.push_back(wheel.span);
    m_planetTip[c] = std::max(m_planetTip[c], nominalTipRadius(gear.spec));
  }
  for (auto& [c, p] : planets) {
    std::sort(p.wheels.begin(), p.wheels.end(),
              [](const Interval& a, const Interval& b) { return a.low < b.low; });
    m_made.planets.push_back(std::move(p));
  }
}

/// Intervals between the faces of all wheels; those that nearly coincide count as one.
void SectionMaker::cutColumns() {
  std::vector<Interval> filled;
  for (const Wheel& w : m_wheels) filled.push_back(w.span);
  for (const CoaxialPlanets& p : m_made.planets)
    filled.insert(filled.end(), p.wheels.begin(), p.wheels.end());
  std::vector<double> faces;
  for (const Interval& s : filled) faces.insert(faces.end(), {s.low, s.high});
  std::sort(faces.begin(), faces.end());
  std::vector<double> edges;
  for (const double f : faces) {
    if (edges.empty() || f - edges.back() > 0.3 * m_made.module) edges.push_back(f);
  }
  const int links = static_cast<int>(m_axis.bearings.size());
  const int ends = std::min(links, kMaxSleeves) + 1;
  const double pitch = kPitch * m_made.module;
  for (int i = ends; i > 0; --i)
    m_made.columns.push_back({edges.front() - i * pitch, edges.front() - (i - 1) * pitch, -1, i - 1});
  for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
    const double middle = (edges[e] + edges[e + 1]) / 2;
    const bool wheel = std::any_of(filled.begin(), filled.end(),
                                   [&](const Interval& s) { return s.low < middle && middle < s.high; });
    if (wheel) {
      m_made.columns.push_back({edges[e], edges[e + 1], 0, 0});
    } else {
      addSlots(edges[e], edges[e + 1]);
    }
  }
  for (int i = 0; i < ends; ++i)
    m_made.columns.push_back({edges.back() + i * pitch, edges.back() + (i + 1) * pitch, 1, i});
}

/// Slots for discs, from both wheels inwards; what is left stays in the middle.
void SectionMaker::addSlots(double low, double high) {
  const double room = (high - low) / m_made.module;
  const int slots = std::clamp(static_cast<int>(room / kNarrowest), 0, kMaxSlots);
  if (slots == 0) {
    m_made.columns.push_back({low, high, 0, 0});
    return;
  }
  const double pitch = std::min(kPitch, room / slots) * m_made.module;
  const int first = (slots + 1) / 2;
  for (int i = 0; i < first; ++i) m_made.columns.push_back({low + i * pitch, low + (i + 1) * pitch, 0, 0});
  const double rest = high - (slots - first) * pitch;
  if (rest - (low + first * pitch) > 1e-6 * m_made.module)
    m_made.columns.push_back({low + first * pitch, rest, 0, 0});
  for (int i = slots - first; i > 0; --i)
    m_made.columns.push_back({high - i * pitch, high - (i - 1) * pitch, 0, 0});
}

void SectionMaker::cutRows() {
  ProfileGrid& grid = m_made.grid;
  const int links = static_cast<int>(m_axis.bearings.size());
  m_made.innerRows = std::min(links, kMaxSleeves);
  double room = (1.8 + 1.0 * (m_made.innerRows - 1)) * m_made.module;
  double most = 0;
  for (const Wheel& w : m_wheels) {
    if (!isRing(spec(w))) room = std::min(room, shaftRoom(spec(w)));
    most = std::max(most, outerRadius(spec(w)));
  }
  for (const CoaxialPlanets& p : m_made.planets) {
    room = std::min(room, p.distance - m_planetTip[p.axisGroup] - 0.4 * m_made.module);
    most = std::max(most, p.distance + m_planetTip[p.axisGroup]);
  }
  m_made.innerRadius = std::max(room, 0.5 * m_made.module);
  const double perRow = static_cast<double>(m_made.columns.size()) * (links + 1);
  const double mostRows = std::clamp(static_cast<double>(kMaxRoutedCells) / perRow, kMinRows, kMaxRows);
  m_made.cell = std::max(m_made.cell, (most - m_made.innerRadius) / mostRows);
  const int middle = static_cast<int>(std::ceil((most - m_made.innerRadius) / m_made.cell)) + 1;
  grid.columns = static_cast<int>(m_made.columns.size());
  grid.rows = m_made.innerRows + middle + std::min(links, 6);
  grid.owner.assign(static_cast<std::size_t>(grid.columns * grid.rows), ProfileGrid::kFree);
  for (const CoaxialColumn& column : m_made.columns) {
    const double width = std::min((column.high - column.low) / m_made.module, kMaxWidth);
    grid.plates.push_back(width > 0.99 * kNarrowest);
    grid.width.push_back(width);
  }
  for (int r = 0; r < grid.rows; ++r) grid.rowCost.push_back(r < m_made.innerRows ? 0.2 : 1);
}

void SectionMaker::blockPlanets(const CoaxialPlanets& p) {
  const double reach = m_planetTip[p.axisGroup] + 0.4 * m_made.module;
  for (const Interval& s : p.wheels) block(s, p.distance - reach, p.distance + reach);
  const double shaft = 2.2 * m_made.module;
  block({p.wheels.front().low, p.wheels.back().high, 0}, p.distance - shaft, p.distance + shaft);
}

/// Wheels that do not go round: nothing may reach out to them.
void SectionMaker::blockBeside(const Wheel& wheel) {
  const double reach = nominalTipRadius(spec(wheel)) + 0.4 * m_made.module;
  block(wheel.span, wheel.distance - reach, 1e300);
}

int SectionMaker::netOf(LinkOrdinal link) {
  const auto [known, added] = m_netOf.try_emplace(link, static_cast<int>(m_made.nets.size()));
  // What stands on the ground need not hang together.
  if (!added && link != 0) return known->second;
  m_made.nets.emplace_back();
  m_made.linkOf.push_back(link);
  m_made.planetsOf.emplace_back();
  return static_cast<int>(m_made.nets.size()) - 1;
}

/// A wheel is its net's; a ring is landed on behind its roots, another on its hub.
void SectionMaker::addWheel(const Wheel& wheel) {
  const GearSpec& s = spec(wheel);
  const bool ring = isRing(s);
  const double play = 0.3 * m_made.module;
  const double rim = ring ? rimDiameter(s) / 2 : 0;
  block(wheel.span, ring ? nominalTipRadius(s) - play : 0, ring ? rim + play : nominalTipRadius(s) + play);
  const NetOrdinal net = netOf(wheel.span.link);
  m_made.netsOfGear[wheel.gear].push_back(net);
  RouteTerminal terminal;
  const auto own = [&](int c, int r) {
    m_made.grid.owner[m_made.grid.cell(c, r)] = net;
    terminal.cells.push_back(m_made.grid.cell(c, r));
  };
  if (ring) {
    const double middle = (nominalRootRadius(s) + rim) / 2 + 0.4 * m_made.module;  // clear of the spaces
    forCells(wheel.span, middle - 1e-9 * m_made.module, middle + 1e-9 * m_made.module, own);
  } else {
    forCells(wheel.span, m_made.innerRadius + 0.1 * m_made.cell, m_made.innerRadius + 0.9 * m_made.cell, own);
  }
  m_made.nets[net].groups.push_back({terminal});
  m_made.planetsOf[net].emplace_back();
  if (wheel.span.link != 0) return;
  // A wheel of the ground stands in the housing: from its rim outwards nothing else may be.
  ProfileNet& held = m_made.nets[net];
  held.needsSupport = true;
  if (!ring) {
    addSupports(net, true);
    return;
  }
  const auto [first, last] = columnsOf(wheel.span);
  for (int c = first; c <= last; ++c) {
    RouteTerminal out;
    out.cells = terminal.cells;
    int r = m_made.innerRows;
    while (r < m_made.grid.rows && m_made.rowLow(r) <= rim + play) ++r;
    out.keptFree = m_made.grid.above(c, r);
    held.supports.push_back(out);
  }
}

/// Where the bosses or the disc about the planets' pins may stand: beside their wheels, or one farther.
std::vector<RouteTerminal> SectionMaker::pinTerminals(const CoaxialPlanets& p) const {
  const ProfileGrid& grid = m_made.grid;
  const double boss = kPinBoss * m_made.module;
  int low = m_made.innerRows;
  while (low < grid.rows && m_made.rowLow(low) + m_made.cell <= p.distance - boss) ++low;
  int high = low;
  while (high < grid.rows && m_made.rowLow(high) < p.distance + boss) ++high;
  const auto bandOf = [&](int c) { return ProfileRun{grid.cell(c, low), grid.cell(c, high)}; };
  const auto terminalAt = [&](int c) {
    RouteTerminal terminal;
    for (CellOrdinal cell = bandOf(c).first; cell < bandOf(c).end; ++cell) terminal.cells.push_back(cell);
    return terminal;
  };
  std::vector<RouteTerminal> terminals;
  for (const Interval& s : p.wheels) {
    const auto [first, last] = columnsOf(s);
    for (const int side : {1, -1}) {
      const int beside = side > 0 ? last + 1 : first - 1;
      const int farther = beside + side;
      const auto inside = [&](int c) { return c >= 0 && c < grid.columns; };
      if (!inside(beside)) continue;
      if (grid.plates[beside]) terminals.push_back(terminalAt(beside));
      if (!inside(farther) || !grid.plates[farther]) continue;
      terminals.push_back(terminalAt(farther));
      terminals.back().keptFree = bandOf(beside);
      terminals.back().cost = 6;
    }
  }
  return terminals;
}

/// Identical planets of one carrier are carried in the same way.
void SectionMaker::addCarried() {
  const auto identical = [&](const CoaxialPlanets& a, const CoaxialPlanets& b) {
    const double step = 1e-6 * m_made.module;
    return a.carrier == b.carrier && std::abs(a.distance - b.distance) < step &&
           std::equal(a.wheels.begin(), a.wheels.end(), b.wheels.begin(), b.wheels.end(),
                      [&](const Interval& x, const Interval& y) {
                        return std::abs(x.low - y.low) < step && std::abs(x.high - y.high) < step;
                      });
  };
  std::vector<bool> done(m_made.planets.size(), false);
  for (std::size_t i = 0; i < m_made.planets.size(); ++i) {
    if (done[i]) continue;
    const NetOrdinal net = netOf(m_made.planets[i].carrier);
    m_made.nets[net].groups.push_back(pinTerminals(m_made.planets[i]));
    m_made.planetsOf[net].emplace_back();
    if (m_made.planets[i].carrier == 0) addHousing(net);
    for (std::size_t k = i; k < m_made.planets.size(); ++k) {
      if (done[k] || !identical(m_made.planets[i], m_made.planets[k])) continue;
      done[k] = true;
      m_made.planetsOf[net].back().push_back(k);
    }
  }
}

/// What the ground carries hangs on the housing, which is outside of everything.
void SectionMaker::addHousing(NetOrdinal net) {
  ProfileNet& held = m_made.nets[net];
  held.needsSupport = true;
  for (int c = 0; c < m_made.grid.columns; ++c) {
    if (m_made.grid.plates[c]) held.supports.push_back({{m_made.grid.cell(c, m_made.grid.rows - 1)}, {}, 0});
  }
}

/// Out at an end, with the room about it for the bearing; what has one wheel only may run on what is inside.
void SectionMaker::addSupports(NetOrdinal net, bool onGround) {
  const ProfileGrid& grid = m_made.grid;
  ProfileNet& held = m_made.nets[net];
  for (int c = 0; c < grid.columns; ++c) {
    if (!grid.plates[c]) continue;
    const CoaxialColumn& column = m_made.columns[c];
    for (int r = 0; r < m_made.innerRows; ++r) {
      RouteTerminal terminal;
      terminal.cells = {grid.cell(c, r)};
      if (column.end != 0 && onGround) {
        terminal.cost = 2.0 * std::abs(column.rank - (m_made.innerRows - 1 - r));
        terminal.keptFree = grid.above(c, r + 1);
        held.supports.push_back(terminal);
      } else if (m_runOn && held.needsSupport && column.end == 0) {
        terminal.cost = kRunsOn;
        held.supports.push_back(terminal);
      }
    }
  }
}

void SectionMaker::makeNets() {
  m_made.netsOfGear.resize(m_train.gears.size());
  for (const Wheel& wheel : m_wheels) addWheel(wheel);
  addCarried();
  for (std::size_t n = 0; n < m_made.nets.size(); ++n) {
    const LinkOrdinal link = m_made.linkOf[n];
    if (link == 0) continue;
    m_made.nets[n].needsSupport = m_made.nets[n].groups.size() == 1;
    addSupports(static_cast<int>(n), m_placement.tree->parent[link] == 0);
  }
}

}  // namespace

double shaftRoom(const GearSpec& spec) {
  return spec.bore > 0 ? spec.bore / 2 : 0.45 * largestBore(spec);
}

CoaxialSections coaxialSections(AxisGroupOrdinal axisGroup, SpanByClass<const AxisLayout> axes,
                                const Placement& placement, const GearTrain& train, bool runOn) {
  return SectionMaker(axisGroup, axes, placement, train, runOn).make();
}

}  // namespace geargraph
