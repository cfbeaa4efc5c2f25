#include "core/machine/body_layout/coaxial_plan.h"

#include <algorithm>
#include <cmath>

#include "core/machine/body_layout/coaxial_sections.h"
#include "core/machine/body_layout/profile_outline.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

/// Makes bodies of the ways that were found.
class CoaxialMaker {
 public:
  CoaxialMaker(AxisGroupOrdinal axisGroup, SpanByClass<const AxisLayout> axes, const Placement& placement,
               const GearTrain& train, const CoaxialSections& sections, ByNet<ProfileRoute> routes)
      : m_class(axisGroup),
        m_axes(axes),
        m_placement(placement),
        m_train(train),
        m_sections(sections),
        m_grid(sections.grid),
        m_routes(std::move(routes)),
        m_owner(sections.grid.owner.size(), -1),
        m_isBody(sections.grid.owner.size(), false),
        m_margin(0.4 * sections.module) {}

  CoaxialPlan make() {
    for (std::size_t n = 0; n < m_routes.size(); ++n) {
      for (const int c : m_routes[n].cells) m_owner[c] = static_cast<int>(n);
    }
    for (std::size_t n = 0; n < m_routes.size(); ++n) addSleeves(static_cast<int>(n));
    nestSleeves();
    joinSleeves();
    setWidth();
    for (std::size_t n = 0; n < m_routes.size(); ++n) {
      markBodies(static_cast<int>(n));
      carryPlanets(static_cast<int>(n));
      addWalls(static_cast<int>(n));
      openDrums(static_cast<int>(n));
      addRevolvedBodies(static_cast<int>(n));
      placeBearing(static_cast<int>(n));
    }
    setHubs();
    return std::move(m_plan);
  }

 private:
  struct Sleeve {
    NetOrdinal net;
    int row = 0, first = 0, last = 0;
    std::size_t shaft = 0;
  };
  void addSleeves(NetOrdinal net);
  void nestSleeves();
  void joinSleeves();
  void setWidth();
  void markBodies(NetOrdinal net);
  void carryPlanets(NetOrdinal net);
  [[nodiscard]] bool isSpider(NetOrdinal net, const RouteTerminal& terminal) const;
  void addWalls(NetOrdinal net);
  void openDrums(NetOrdinal net);
  void addRevolvedBodies(NetOrdinal net);
  void placeBearing(NetOrdinal net);
  void setHubs();

  [[nodiscard]] LinkOrdinal link(NetOrdinal net) const { return m_sections.linkOf[net]; }
  [[nodiscard]] const CoaxialColumn& column(int c) const { return m_sections.columns[c]; }
  [[nodiscard]] double middleOf(int c) const { return (column(c).low + column(c).high) / 2; }
  [[nodiscard]] bool owns(NetOrdinal net, int c, int r) const {
    return c >= 0 && c < m_grid.columns && r >= 0 && r < m_grid.rows && m_owner[m_grid.cell(c, r)] == net;
  }
  [[nodiscard]] bool isWheel(CellOrdinal cell) const { return m_grid.owner[cell] >= 0; }
  /// Is the cell a wall of the net at hand, or the place of its wheel that one joins?
  [[nodiscard]] bool isWall(NetOrdinal net, int c, int r) const {
    if (c < 0 || c >= m_grid.columns || r < m_sections.innerRows || r >= m_grid.rows) return false;
    const CellOrdinal cell = m_grid.cell(c, r);
    return m_isBody[cell] || m_grid.owner[cell] == net;
  }
  [[nodiscard]] int jointRow(NetOrdinal net, int c, int r) const;
  [[nodiscard]] double wallPlace(NetOrdinal net, int c) const;
  [[nodiscard]] bool hasWheel(NetOrdinal net, int c) const {
    for (int r = m_sections.innerRows; r < m_grid.rows; ++r) {
      if (m_grid.owner[m_grid.cell(c, r)] == net) return true;
    }
    return false;
  }
  /// The net's inmost sleeve in a column; nothing: it has none.
  [[nodiscard]] const Sleeve* sleeveIn(NetOrdinal net, int c) const {
    for (const Sleeve& s : m_sleeves) {
      if (s.net == net && s.first <= c && c <= s.last) return &s;
    }
    return nullptr;
  }
  [[nodiscard]] double wallMiddle(const Sleeve& s) const {
    const ShaftSegment& shaft = m_plan.shafts[s.shaft];
    return shaft.inner > 0 ? (shaft.inner + shaft.outer) / 2 : shaft.outer / 2;
  }

  int m_class;
  SpanByClass<const AxisLayout> m_axes;
  const Placement& m_placement;
  const GearTrain& m_train;
  const CoaxialSections& m_sections;
  const ProfileGrid& m_grid;
  ByNet<ProfileRoute> m_routes;
  ByCell<NetOrdinal> m_owner;     ///< -1: none
  ByCell<bool> m_isBody;          ///< of the net at hand: cells that become bodies of revolution
  double m_margin;                ///< between cells and what fills them, along the axis
  std::vector<Sleeve> m_sleeves;  ///< by net, then row
  CoaxialPlan m_plan;
};

/// Runs along a row within the wheels; a row that is only crossed has none.
void CoaxialMaker::addSleeves(NetOrdinal net) {
  const auto add = [&](int row, int first, int last) {
    ShaftSegment shaft;
    shaft.axisGroup = m_class;
    shaft.link = link(net);
    shaft.include(column(first).low, column(last).high);
    const double module = m_sections.module;
    // Out of the own hub, but not as far as the next sleeve comes.
    shaft.low += hasWheel(net, first) ? -0.16 * module : 0.2 * module;
    shaft.high += hasWheel(net, last) ? 0.16 * module : -0.2 * module;
    m_sleeves.push_back({net, row, first, last, m_plan.shafts.size()});
    m_plan.shafts.push_back(shaft);
  };
  for (int row = 0; row < m_sections.innerRows; ++row) {
    for (int c = 0; c < m_grid.columns; ++c) {
      if (!owns(net, c, row)) continue;
      int last = c;
      while (owns(net, last + 1, row)) ++last;
      const bool crossed = owns(net, c, row - 1) || owns(net, c, row + 1);
      if (last > c || !crossed) add(row, c, last);
      c = last;
    }
  }
  // Crossed rows without a run beside: the inmost of the column.
  for (int c = 0; c < m_grid.columns; ++c) {
    if (sleeveIn(net, c) != nullptr) continue;
    for (int row = 0; row < m_sections.innerRows; ++row) {
      if (!owns(net, c, row)) continue;
      add(row, c, c);
      break;
    }
  }
}

/// Sleeves about what lies inside; all shrink together until every wheel holds its own.
void CoaxialMaker::nestSleeves() {
  const double module = m_sections.module;
  std::vector<const Sleeve*> order;
  for (const Sleeve& s : m_sleeves) order.push_back(&s);
  std::stable_sort(order.begin(), order.end(),
                   [](const Sleeve* a, const Sleeve* b) { return a->row < b->row; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    ShaftSegment& shaft = m_plan.shafts[order[i]->shaft];
    double inside = 0;
    for (std::size_t k = 0; k < i; ++k) {
      const ShaftSegment& other = m_plan.shafts[order[k]->shaft];
      const bool over = order[k]->first <= order[i]->last && order[i]->first <= order[k]->last;
      if (over && order[k]->net != order[i]->net) inside = std::max(inside, other.outer);
    }
    shaft.wrap(inside, module);
  }
  double scale = 1;
  for (const ShaftSegment& shaft : m_plan.shafts)
    scale = std::min(scale, m_sections.innerRadius / shaft.outer);
  for (ShaftSegment& shaft : m_plan.shafts) {
    shaft.inner *= scale;
    shaft.outer *= scale;
  }
}

/// Sleeves of a net that lie over each other and came out equally wide are one.
void CoaxialMaker::joinSleeves() {
  const auto shaftOf = [&](const Sleeve& s) -> ShaftSegment& { return m_plan.shafts[s.shaft]; };
  const auto isOne = [&](const Sleeve& a, const Sleeve& b) {
    return a.net == b.net && a.first <= b.last && b.first <= a.last &&
           std::abs(shaftOf(a).outer - shaftOf(b).outer) < 1e-9 * m_sections.module &&
           std::abs(shaftOf(a).inner - shaftOf(b).inner) < 1e-9 * m_sections.module;
  };
  for (std::size_t i = 0; i < m_sleeves.size(); ++i) {
    for (std::size_t k = i + 1; k < m_sleeves.size();) {
      Sleeve& one = m_sleeves[i];
      const Sleeve other = m_sleeves[k];
      if (!isOne(one, other)) {
        ++k;
        continue;
      }
      shaftOf(one).include(shaftOf(other).low, shaftOf(other).high);
      one.first = std::min(one.first, other.first);
      one.last = std::max(one.last, other.last);
      m_sleeves.erase(m_sleeves.begin() + static_cast<std::ptrdiff_t>(k));
      k = i + 1;  // the longer one may reach others
    }
  }
  std::vector<ShaftSegment> kept;
  for (Sleeve& s : m_sleeves) {
    kept.push_back(shaftOf(s));
    s.shaft = kept.size() - 1;
  }
  m_plan.shafts = std::move(kept);
}

/// Arms are as wide as the narrowest slot that one stands in.
void CoaxialMaker::setWidth() {
  double width = m_axes[m_class].width();
  for (std::size_t n = 0; n < m_routes.size(); ++n) {
    for (std::size_t g = 0; g < m_routes[n].terminal.size(); ++g) {
      if (m_sections.planetsOf[n][g].empty()) continue;
      const auto& terminal = m_sections.nets[n].groups[g][static_cast<std::size_t>(m_routes[n].terminal[g])];
      const CoaxialColumn& c = column(m_grid.columnOf(terminal.cells.front()));
      width = std::min(width, c.high - c.low - 1.5 * m_margin);
    }
  }
  m_plan.width = width / m_sections.module;
}

void CoaxialMaker::markBodies(NetOrdinal net) {
  m_isBody.assign(m_isBody.size(), false);
  for (const int c : m_routes[net].cells) {
    if (m_grid.rowOf(c) >= m_sections.innerRows && !isWheel(c)) m_isBody[c] = true;
  }
}

/// Do only arms lead from the terminal straight to the link's sleeve?
bool CoaxialMaker::isSpider(NetOrdinal net, const RouteTerminal& terminal) const {
  const int c = m_grid.columnOf(terminal.cells.front());
  const int top = m_grid.rowOf(terminal.cells.back());
  const Sleeve* sleeve = sleeveIn(net, c);
  if (sleeve == nullptr) return false;
  for (int r = m_sections.innerRows; r < m_grid.rows; ++r) {
    const bool own = owns(net, c, r);
    if (own != (r <= top)) return false;
    if (own && (owns(net, c - 1, r) || owns(net, c + 1, r))) return false;
  }
  return true;
}

void CoaxialMaker::carryPlanets(NetOrdinal net) {
  for (std::size_t g = 0; g < m_routes[net].terminal.size(); ++g) {
    const auto& carried = m_sections.planetsOf[net][g];
    if (carried.empty()) continue;
    const RouteTerminal& terminal = m_sections.nets[net].groups[g][m_routes[net].terminal[g]];
    const int c = m_grid.columnOf(terminal.cells.front());
    const double level = middleOf(c);
    const bool spider = isSpider(net, terminal);
    for (const std::size_t i : carried) {
      const CoaxialPlanets& planets = m_sections.planets[i];
      const AxisLayout& there = m_axes[planets.axisGroup];
      const double sense = there.direction.dot(m_axes[m_class].direction) < 0 ? -1 : 1;
      const auto carriedTo = [&](double x) { return there.coordinate(m_axes[m_class].at(x)); };
      for (const Bearing& b : there.bearings) {
        if (spider) {
          m_plan.arms.push_back({link(net), m_class, level, planets.axisGroup, carriedTo(level), b.child});
          m_plan.bearings.push_back({b.joint, carriedTo(level), BearingForm::boss});
          continue;
        }
        const bool below = level < planets.wheels.front().low;
        const double end = below ? planets.wheels.back().high : planets.wheels.front().low;
        const double to = carriedTo(end) + (below ? 1 : -1) * sense * 0.1 * m_sections.module;
        if (&b == &there.bearings.front())
          m_plan.pins.push_back({link(net), -1, level, planets.axisGroup, carriedTo(level), to});
        m_plan.bearings.push_back({b.joint, to, BearingForm::hidden});
      }
    }
    if (!spider) continue;
    for (int r = m_sections.innerRows; r < m_grid.rows; ++r) m_isBody[m_grid.cell(c, r)] = false;
  }
}

/// Walls side by side in two columns are joined in one row: that of a wheel, else the inmost. The row where
/// the block about this one, in a column and the next, is joined; -1: there is none.
int CoaxialMaker::jointRow(NetOrdinal net, int c, int r) const {
  const auto both = [&](int row) { return isWall(net, c, row) && isWall(net, c + 1, row); };
  if (!both(r)) return -1;
  int first = r;
  while (both(first - 1)) --first;
  for (int row = first; both(row); ++row) {
    if (isWheel(m_grid.cell(c, row)) || isWheel(m_grid.cell(c + 1, row))) return row;
  }
  return first;
}

/// Where along the axis a wall in a column is: at the middle of the net's wheel there, else of the column.
double CoaxialMaker::wallPlace(NetOrdinal net, int c) const {
  const AxisLayout& axis = m_axes[m_class];
  for (std::size_t g = 0; g < m_sections.netsOfGear.size(); ++g) {
    const std::vector<NetOrdinal>& nets = m_sections.netsOfGear[g];
    if (std::find(nets.begin(), nets.end(), net) == nets.end() || !hasWheel(net, c)) continue;
    const double middle = axis.coordinate(m_train.gears[g].pose.translation());
    const double half = m_train.gears[g].spec.faceWidth / 2;
    if (column(c).high > middle - half && column(c).low < middle + half) return middle;
  }
  return middleOf(c);
}

/// The net's walls by their middles, without dead ends.
void CoaxialMaker::addWalls(NetOrdinal net) {
  if (link(net) == 0) return;
  const auto level = [&](int c, int r) { return jointRow(net, c, r) == r; };
  for (int r = m_sections.innerRows; r < m_grid.rows; ++r) {
    for (int c = 0; c < m_grid.columns; ++c) {
      if (!level(c, r)) continue;
      int last = c + 1;
      while (level(last, r)) ++last;
      const double from = wallPlace(net, c), to = wallPlace(net, last), radius = m_sections.rowMiddle(r);
      if (from < to) m_plan.walls.push_back({m_class, link(net), from, to, radius, radius});
      c = last - 1;
    }
  }
  for (int c = 0; c < m_grid.columns; ++c) {
    for (int r = m_sections.innerRows; r < m_grid.rows; ++r) {
      if (!isWall(net, c, r)) continue;
      WallPlan wall{m_class, link(net), wallPlace(net, c), wallPlace(net, c), 1e300, -1e300};
      wall.isOnShaft = r == m_sections.innerRows && owns(net, c, r - 1) && sleeveIn(net, c) != nullptr;
      const auto include = [&](double radius) {
        wall.fromRadius = std::min(wall.fromRadius, radius);
        wall.toRadius = std::max(wall.toRadius, radius);
      };
      if (wall.isOnShaft) include(m_sections.innerRadius);
      for (; isWall(net, c, r); ++r) {
        if (isWheel(m_grid.cell(c, r)) || level(c, r) || level(c - 1, r)) include(m_sections.rowMiddle(r));
        for (std::size_t g = 0; g < m_routes[net].terminal.size(); ++g) {
          const RouteTerminal& terminal = m_sections.nets[net].groups[g][m_routes[net].terminal[g]];
          if (m_grid.columnOf(terminal.cells.front()) != c) continue;
          for (const std::size_t p : m_sections.planetsOf[net][g]) {
            const double distance = m_sections.planets[p].distance;
            if (m_sections.rowLow(r) <= distance && distance < m_sections.rowLow(r + 1)) include(distance);
          }
        }
      }
      if (wall.fromRadius < wall.toRadius) m_plan.walls.push_back(wall);
    }
  }
}

/// Longer walls of drums become bars, which overlap what stands at their ends.
void CoaxialMaker::openDrums(NetOrdinal net) {
  const double module = m_sections.module;
  const auto body = [&](int c, int r) {
    return c >= 0 && c < m_grid.columns && r >= 0 && r < m_grid.rows && m_isBody[m_grid.cell(c, r)];
  };
  const auto isWall = [&](int c, int r) {
    return body(c, r) && owns(net, c - 1, r) && owns(net, c + 1, r) && !body(c, r - 1) && !body(c, r + 1);
  };
  const ByCell<bool> before = m_isBody;
  for (int r = m_sections.innerRows + 1; r + 1 < m_grid.rows; ++r) {
    for (int c = 0; c < m_grid.columns; ++c) {
      if (!isWall(c, r)) continue;
      int last = c;
      while (isWall(last + 1, r)) ++last;
      const double length = column(last).high - column(c).low;
      if (length > 5 * module && m_sections.rowLow(r) > 6 * module) {
        const auto into = [&](int beside) {
          return hasWheel(net, beside) ? 0.2 * module : m_margin + 0.2 * module;
        };
        m_plan.cages.push_back({m_class, link(net), m_sections.rowLow(r) + 0.25 * module,
                                m_sections.rowLow(r + 1) - 0.25 * module, column(c).low - into(c - 1),
                                column(last).high + into(last + 1)});
        for (int k = c; k <= last; ++k) m_isBody[m_grid.cell(k, r)] = false;
      }
      c = last;
    }
  }
}

void CoaxialMaker::addRevolvedBodies(NetOrdinal net) {
  const double module = m_sections.module;
  OutlinePlaces places;
  places.height = [&](CellOrdinal cell, int side) {
    const int c = m_grid.columnOf(cell);
    const double edge = side < 0 ? column(c).low : column(c).high;
    const int beside = c + side;
    const bool wheel = beside >= 0 && beside < m_grid.columns && owns(net, beside, m_grid.rowOf(cell)) &&
                       isWheel(m_grid.cell(beside, m_grid.rowOf(cell)));
    return edge + side * (wheel ? 0.2 * module : -m_margin);  // into the own wheel, off the neighbours
  };
  places.radius = [&](CellOrdinal cell, int side) {
    const int r = m_grid.rowOf(cell);
    const int c = m_grid.columnOf(cell);
    const double inset = 0.2 * module;
    if (side > 0) return m_sections.rowLow(r + 1) - inset;
    const bool joined = r == m_sections.innerRows && owns(net, c, r - 1);
    const Sleeve* sleeve = joined ? sleeveIn(net, c) : nullptr;
    return sleeve != nullptr ? wallMiddle(*sleeve) : m_sections.rowLow(r) + inset;
  };
  RevolvedPlan plan{m_class, link(net), outlinesOf(m_grid, m_isBody, places)};
  // Where a link changes from one sleeve to another, a disc joins them.
  for (int c = 0; c < m_grid.columns; ++c) {
    const Sleeve* low = nullptr;
    const Sleeve* high = nullptr;
    for (const Sleeve& s : m_sleeves) {
      if (s.net != net || s.first > c || s.last < c) continue;
      if (low == nullptr) low = &s;
      high = &s;
    }
    if (low == high) continue;
    const double from = wallMiddle(*low), to = m_plan.shafts[high->shaft].outer - 0.05 * module;
    const double bottom = column(c).low + m_margin, top = column(c).high - m_margin;
    plan.profiles.push_back({{to, top}, {from, top}, {from, bottom}, {to, bottom}});
  }
  if (!plan.profiles.empty()) m_plan.revolvedBodies.push_back(std::move(plan));
}

/// The bearing of the net's link on this axis: at the end where it comes out.
void CoaxialMaker::placeBearing(NetOrdinal net) {
  if (link(net) == 0) return;
  const JointTree& tree = *m_placement.tree;
  const ProfileRoute& route = m_routes[net];
  CoaxialBearing bearing{tree.joint[link(net)], 0, BearingForm::hidden};
  if (route.support >= 0) {
    const RouteTerminal& terminal = m_sections.nets[net].supports[static_cast<std::size_t>(route.support)];
    const int c = m_grid.columnOf(terminal.cells.front());
    bearing.at = middleOf(c);
    if (column(c).end != 0) bearing.form = BearingForm::boss;
  }
  m_plan.bearings.push_back(bearing);
}

/// Hubs reach as far out as the discs that stand on them.
void CoaxialMaker::setHubs() {
  for (std::size_t g = 0; g < m_sections.netsOfGear.size(); ++g) {
    const GearSpec& spec = m_train.gears[g].spec;
    if (m_sections.netsOfGear[g].empty() || isRing(spec)) continue;
    const NetOrdinal net = m_sections.netsOfGear[g].front();
    const int row = m_sections.innerRows;
    for (const CellOrdinal cell : m_routes[net].cells) {
      const int c = m_grid.columnOf(cell);
      if (m_grid.rowOf(cell) != row || isWheel(cell)) continue;
      const bool beside = (c > 0 && m_grid.owner[m_grid.cell(c - 1, row)] == net) ||
                          (c + 1 < m_grid.columns && m_grid.owner[m_grid.cell(c + 1, row)] == net);
      const double hub = 2 * (m_sections.rowLow(row + 1) + 0.2 * m_sections.module);
      if (beside && (m_plan.hubs.empty() || m_plan.hubs.back().first != g)) m_plan.hubs.push_back({g, hub});
    }
  }
}

}  // namespace

bool needsCoaxialPlan(AxisGroupOrdinal axisGroup, const Placement& placement, const GearTrain& train) {
  const AxisGroups& classes = *placement.classes;
  const JointTree& tree = *placement.tree;
  const auto isOf = [&](LinkOrdinal link) { return classes.classOfLink(link) == axisGroup; };
  if (classes.classes[axisGroup].rootLink != 0) return false;
  int rings = 0;
  for (const TrainGear& gear : train.gears) {
    if (gear.axisGroup == axisGroup && isRing(gear.spec)) ++rings;
    if (gear.axisGroup == axisGroup && isConical(gear.spec)) return false;
    if (gear.axisGroup == axisGroup && gear.link != 0 && !isOf(gear.link)) return false;
    const LinkOrdinal rootLink = classes.classes[gear.axisGroup].rootLink;
    if (gear.axisGroup == axisGroup || !isOf(rootLink)) continue;
    if (isRing(gear.spec) || !(classes.classOfLink(gear.link) == gear.axisGroup)) return false;
  }
  if (rings < 2) return false;
  for (std::size_t c = 0; c < classes.classes.size(); ++c) {
    const LinkOrdinal rootLink = classes.classes[c].rootLink;
    if (isOf(rootLink)) {  // planets: on parallel axes, and nothing on them
      const auto own = placement.lineOfClass(axisGroup).direction;
      const auto other = placement.lineOfClass(static_cast<int>(c)).direction;
      if (std::abs(std::abs(dot(own, other)) - 1) > 1e-9) return false;
    } else if (rootLink != 0 && isOf(tree.parent[rootLink])) {
      return false;
    }
  }
  return true;
}

std::optional<CoaxialPlan> coaxialPlan(AxisGroupOrdinal axisGroup, SpanByClass<const AxisLayout> axes,
                                       const Placement& placement, const GearTrain& train,
                                       const std::stop_token& stop) {
  for (const bool runOn : {false, true}) {
    const CoaxialSections sections = coaxialSections(axisGroup, axes, placement, train, runOn);
    auto routes = routeProfiles(sections.grid, sections.nets, kMaxRouteRounds, stop);
    if (routes) return CoaxialMaker(axisGroup, axes, placement, train, sections, std::move(*routes)).make();
  }
  return std::nullopt;
}

}  // namespace geargraph
