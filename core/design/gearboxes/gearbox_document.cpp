#include "core/design/gearboxes/gearbox_document.h"

#include <algorithm>
#include <memory>

#include "core/design/synthesis/set_sketch.h"
#include "core/design/synthesis/shifting_sets.h"
#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/statics/shift_statics.h"

namespace geargraph {
namespace {

constexpr int kSetDistance = 60;  // along the axis, mm
constexpr int kSmallSunPlace = 20;
constexpr int kFaceWidth = 14;

std::string elementName(std::size_t position) {
  return {static_cast<char>('A' + position)};
}

/// "input, R1": the members that are on a link.
std::string linkName(const BasicSets& sets, const GearLayout& layout, int link) {
  std::string name;
  const auto add = [&name](const std::string& word) { name += (name.empty() ? "" : ", ") + word; };
  if (link == layout.input) add(translated("input"));
  if (link == layout.output) add(translated("output"));
  for (int set = 0; set < static_cast<int>(sets.size()); ++set) {
    for (const SetMember member : {SetMember::sun, SetMember::carrier, SetMember::ring}) {
      if (sets[static_cast<std::size_t>(set)].sharesRing && member != SetMember::sun) continue;
      if (layout.link(set, member) == link) add(memberName(set, member));
    }
  }
  return name;
}

/// Builds the meshes of all sets into a sketch whose first links are those of the layout.
class SetMeshes {
 public:
  SetMeshes(const GearboxWish& wish, const Gearbox& gearbox, SetSketch& sketch)
      : m_wish(wish), m_gearbox(gearbox), m_sketch(sketch) {}

  void add() {
    int set = 0;
    for (std::size_t i = 0; i < m_wish.limits.kinds.size(); ++i) {
      m_level = static_cast<int>(i) * kSetDistance;
      const std::vector<SetTeeth>& parts = m_gearbox.teeth[i].parts;
      switch (m_wish.limits.kinds[i]) {
        case SetKind::simple:
          addSimple(set, parts.front());
          break;
        case SetKind::doublePlanet:
          addDouble(set, parts.front());
          break;
        case SetKind::ravigneaux:
          addRavigneaux(set, parts);
          break;
      }
      set += static_cast<int>(parts.size());
    }
  }

 private:
  [[nodiscard]] int linkOf(int set, SetMember member) const { return m_gearbox.layout.link(set, member); }

  int planet(int set, const std::string& axis, const PlanePoint& at, std::string name) {
    m_sketch.axis(axis, {planeCoordinate(at.x), planeCoordinate(at.y), Number(m_level)},
                  {Number(0), Number(0), Number(1)});
    return m_sketch.link(linkOf(set, SetMember::carrier), axis, std::move(name));
  }

  GearMesh& mesh(int tail, int head, int tailTeeth, int headTeeth, MeshKind kind, const NumberTriple& point) {
    GearMesh& made = m_sketch.mesh(tail, head, tailTeeth, headTeeth, kind);
    made.faceWidth = Number(kFaceWidth);
    made.pitchPoint = point;
    if (m_wish.efficiency && !m_wish.efficiency->isOfSet) made.efficiency = Number(m_wish.efficiency->basic);
    return made;
  }

  /// Of a set whose basic efficiency is wished for: the mesh that has all of it.
  void lose(GearMesh& made) const {
    if (m_wish.efficiency && m_wish.efficiency->isOfSet) made.efficiency = Number(m_wish.efficiency->basic);
  }

  void addSimple(int set, const SetTeeth& teeth) {
    const std::string number = std::to_string(set + 1);
    const Rational centre = teeth.sun + teeth.planet;  // half modules of 1: module 2
    const int axisPlanet =
        planet(set, "p" + number, {centre.toDouble(), 0}, translated("planet %1", {number}));
    // Within the slack the ring's pitch circle follows from the distance.
    const Rational ringAt = centre * Rational(teeth.ring, teeth.ring - teeth.planet);
    lose(mesh(linkOf(set, SetMember::sun), axisPlanet, teeth.sun, teeth.planet, MeshKind::external,
              {Number(teeth.sun), Number(0), Number(m_level)}));
    mesh(axisPlanet, linkOf(set, SetMember::ring), teeth.planet, teeth.ring, MeshKind::internal,
         {Number(ringAt), Number(0), Number(m_level)});
  }

  void addDouble(int set, const SetTeeth& teeth) {
    const std::string number = std::to_string(set + 1);
    const auto places = doublePlanetPlaces(teeth.sun, teeth.planet, teeth.outer, teeth.ring);
    GEARGRAPH_REQUIRE(places.has_value());
    const int inner = planet(set, "p" + number, places->shortPlanet, translated("inner planet %1", {number}));
    const int outer = planet(set, "q" + number, places->longPlanet, translated("outer planet %1", {number}));
    lose(mesh(linkOf(set, SetMember::sun), inner, teeth.sun, teeth.planet, MeshKind::external,
              touchingPoint({}, teeth.sun, places->shortPlanet, teeth.planet, m_level)));
    mesh(inner, outer, teeth.planet, teeth.outer, MeshKind::external,
         touchingPoint(places->shortPlanet, teeth.planet, places->longPlanet, teeth.outer, m_level));
    mesh(outer, linkOf(set, SetMember::ring), teeth.outer, teeth.ring, MeshKind::internal,
         touchingPoint(places->longPlanet, teeth.outer, {}, -teeth.ring, m_level));
  }

  void addRavigneaux(int set, const std::vector<SetTeeth>& parts) {
    const RavigneauxTeeth teeth{parts[1].sun, parts[0].sun, parts[1].planet, parts[0].planet};
    const auto places = pairPlaces(teeth);
    GEARGRAPH_REQUIRE(places.has_value());
    const std::string number = std::to_string(set + 1);
    const int shorter =
        planet(set, "p" + number, places->shortPlanet, translated("short planet %1", {number}));
    const int longer = planet(set, "q" + number, places->longPlanet, translated("long planet %1", {number}));
    const WheelId wheel = m_sketch.wheel("long-" + number, longer);  // one, through both planes
    const int small = m_level + kSmallSunPlace;
    mesh(linkOf(set + 1, SetMember::sun), shorter, teeth.smallSun, teeth.shortPlanet, MeshKind::external,
         touchingPoint({}, teeth.smallSun, places->shortPlanet, teeth.shortPlanet, small));
    GearMesh& between = mesh(
        shorter, longer, teeth.shortPlanet, teeth.longPlanet, MeshKind::external,
        touchingPoint(places->shortPlanet, teeth.shortPlanet, places->longPlanet, teeth.longPlanet, small));
    between.headWheel = wheel;
    lose(between);
    GearMesh& large =
        mesh(linkOf(set, SetMember::sun), longer, teeth.largeSun, teeth.longPlanet, MeshKind::external,
             touchingPoint({}, teeth.largeSun, places->longPlanet, teeth.longPlanet, m_level));
    large.headWheel = wheel;
    lose(large);
    mesh(longer, linkOf(set, SetMember::ring), teeth.longPlanet, teeth.ring(), MeshKind::internal,
         touchingPoint(places->longPlanet, teeth.longPlanet, {}, -teeth.ring(), m_level))
        .tailWheel = wheel;
  }

  const GearboxWish& m_wish;
  const Gearbox& m_gearbox;
  SetSketch& m_sketch;
  int m_level = 0;
};

/// Where along the axis a link's bearing is drawn: beside its first member.
int bearingOf(const GearboxWish& wish, const GearLayout& layout, int link) {
  int set = 0;
  for (std::size_t i = 0; i < wish.limits.kinds.size(); ++i) {
    const int parts = wish.limits.kinds[i] == SetKind::ravigneaux ? 2 : 1;
    const int level = static_cast<int>(i) * kSetDistance;
    for (int part = 0; part < parts; ++part, ++set) {
      if (layout.link(set, SetMember::sun) == link) return level - 25 + part * 60;
      if (layout.link(set, SetMember::carrier) == link) return level + 15;
      if (layout.link(set, SetMember::ring) == link) return level - 20;
    }
  }
  return -kSetDistance;
}

std::string notesOf(const GearboxWish& wish, const Gearbox& gearbox) {
  std::string ratios;
  for (const GearState& each : gearbox.gears)
    ratios += (ratios.empty() ? "" : ", ") + each.name + ": " + each.ratio.toString();
  std::string planets;
  for (std::size_t i = 0; i < gearbox.teeth.size(); ++i) {
    planets += i == 0 ? "" : "; ";
    for (std::size_t j = 0; j < gearbox.teeth[i].planets.size(); ++j)
      planets += (j == 0 ? "" : ", ") + std::to_string(gearbox.teeth[i].planets[j]);
  }
  std::string notes = translated(
      "Found by the gearbox designer. Ratios: %1. One planet or pair of each set is drawn; numbers that go "
      "in: "
      "%2.",
      {ratios, planets});
  if (wish.efficiency && wish.efficiency->isOfSet) {
    notes +=
        ' ' + translated(
                  "One mesh of each set has the whole basic efficiency of the set, the others lose nothing.");
  }
  return notes;
}

/// The statics of every gear under a torque at its input. False if `stop` was requested.
bool addLosses(const GearboxWish& wish, const AnalysisSnapshot& snapshot, Gearbox& gearbox,
               const std::stop_token& stop) {
  StaticsOptions options;
  options.losses = wish.efficiency.has_value();
  options.symbolic = false;
  GearboxLosses losses;
  for (int state = 0; state < static_cast<int>(gearbox.gears.size()); ++state) {
    const auto solved =
        solveShiftState(*snapshot.mechanism, *snapshot.kinematics->model, snapshot.kinematics->placement(),
                        *snapshot.kinematics->ttGraph, *snapshot.matroid(), state, options, stop);
    if (!solved) return false;
    auto& efficiency = losses.efficiencies.emplace_back();
    auto& circulating = losses.circulating.emplace_back();
    if (!solved->report || !solved->report->isAnswered() || !solved->report->sums) continue;
    const StaticsReport& report = *solved->report;
    if (const auto value = report.sums->efficiency(); wish.efficiency && value)
      efficiency = value->fraction();
    if (!report.circulations || report.sums->fed.sign() <= 0) continue;
    circulating = report.circulations->empty()
                      ? std::optional(Rational(0))
                      : (report.circulations->front().power / report.sums->fed).fraction();
  }
  gearbox.losses = std::move(losses);
  return true;
}

bool meetsLossLimits(const GearboxWish& wish, const GearboxLosses& losses) {
  if (wish.efficiency && wish.efficiency->least) {
    for (const auto& each : losses.efficiencies) {
      if (!each || *each < *wish.efficiency->least) return false;
    }
  }
  if (wish.circulating) {
    for (const auto& each : losses.circulating) {
      if (!each || *each > *wish.circulating) return false;
    }
  }
  return true;
}

}  // namespace

Mechanism gearboxDocument(const GearboxWish& wish, const Gearbox& gearbox) {
  const BasicSets sets = basicSets(wish.limits.kinds);
  SetSketch sketch(translated("Gearbox"));
  sketch.axis("a", {Number(0), Number(0), Number(0)}, {Number(0), Number(0), Number(1)});
  for (int link = 1; link <= wish.limits.shafts; ++link) {
    const int made = sketch.link(0, "a", linkName(sets, gearbox.layout, link));
    sketch.bearing(made, bearingOf(wish, gearbox.layout, link));
  }
  SetMeshes(wish, gearbox, sketch).add();
  for (std::size_t i = 0; i < gearbox.elements.size(); ++i) {
    const ElementLinks& each = gearbox.elements[i];
    if (each.isBrake()) {
      sketch.brake(elementName(i), each.a);
    } else {
      sketch.clutch(elementName(i), each.a, each.b);
    }
  }
  for (const GearState& gear : gearbox.gears) {
    std::vector<std::string> engaged;
    for (const int each : gear.engaged) engaged.push_back(elementName(static_cast<std::size_t>(each)));
    sketch.state(gear.name, engaged, gearbox.layout.input, gearbox.layout.output);
  }
  for (const int each : gearbox.gears.front().engaged)
    sketch.engage(elementName(static_cast<std::size_t>(each)));
  sketch.input(gearbox.layout.input, Number(1));
  Mechanism mechanism = std::move(sketch).build();
  mechanism.notes = notesOf(wish, gearbox);
  return mechanism;
}

GearboxCheck checkByDocument(const GearboxWish& wish, Gearbox& gearbox, bool statics,
                             const std::stop_token& stop) {
  auto mechanism = std::make_shared<Mechanism>(gearboxDocument(wish, gearbox));
  mechanism->engaged.clear();
  SnapshotPtr snapshot = analyzeLive(std::move(mechanism), 0, stop);
  if (snapshot) snapshot = analyzeStates(snapshot, {false}, stop);
  if (!snapshot) return GearboxCheck::stopped;
  if (!snapshot->states || snapshot->states->size() != gearbox.gears.size()) return GearboxCheck::wrong;
  for (std::size_t i = 0; i < gearbox.gears.size(); ++i) {
    const StateSolution& state = (*snapshot->states)[i];
    if (!state.ratio || *state.ratio != gearbox.gears[i].ratio) return GearboxCheck::wrong;
  }
  const bool isLimited = wish.circulating || (wish.efficiency && wish.efficiency->least);
  if (!statics && !isLimited) return GearboxCheck::right;
  if (snapshot->matroid() == nullptr) return GearboxCheck::wrong;
  if (!addLosses(wish, *snapshot, gearbox, stop)) return GearboxCheck::stopped;
  return meetsLossLimits(wish, *gearbox.losses) ? GearboxCheck::right : GearboxCheck::limited;
}

}  // namespace geargraph
