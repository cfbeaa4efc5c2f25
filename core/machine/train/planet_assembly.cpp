#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "core/foundations/base/disjoint_sets.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/train_diagnostics.h"
#include "core/mechanism/placement/planet_groups.h"

namespace geargraph {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kDegree = std::numbers::pi / 180;
constexpr std::size_t kMaxPlanetNames = 12;

using Gears = std::vector<GearOrdinal>;

/// Gears that meshes tie to each other, so that the phase of one gives that of the others.
DisjointSets tiedGears(const GearTrain& train) {
  DisjointSets tied(train.gears.size());
  for (const TrainMesh& mesh : train.meshes) tied.join(mesh.tailGear, mesh.headGear);
  return tied;
}

/// The same link of each planet of a set, and its gears in corresponding order.
struct EqualLinks {
  std::vector<LinkOrdinal> links;  ///< by planet
  std::vector<Gears> gears;        ///< by planet
};

/// A mesh that ties the turn of a gear to the place of its planet: directly, or through other gears of the
/// planet's group.
struct Tie {
  int teeth = 1;        ///< of the planet's gear
  double turnsPer = 0;  ///< turns of that gear, about its link's axis, per turn of the planet's place
};

/// A set of equal planets with their gears.
class PlanetSet {
 public:
  PlanetSet(const GearTrain& train, const std::vector<int>& meshAt, const std::vector<PlanetGroup>& planets)
      : m_train(train), m_meshAt(meshAt), m_planets(planets) {
    m_isSound = findGears();
  }

  /// False where a mesh has no gears, meshes of equal planets share gears differently, or a loop of meshes
  /// cannot be assembled, which assemblyDiagnostics() reports.
  [[nodiscard]] bool isSound() const { return m_isSound; }
  [[nodiscard]] const std::vector<EqualLinks>& links() const { return m_links; }
  [[nodiscard]] const TrainGear& gear(GearOrdinal g) const { return m_train.gears[g]; }

  /// How far the gear is turned against that of the first planet, about the axis of its link, rad; the same
  /// unknown angle is added for all gears of a link.
  [[nodiscard]] double turnOf(const EqualLinks& of, std::size_t planet, std::size_t which) const {
    return markAngle(of, planet, which) - markAngle(of, 0, which);
  }

  /// The number of places round the central axis at which an equal planet fits; 0: everywhere, or not known.
  [[nodiscard]] std::int64_t places() const;
  /// Angle between the places of a planet and of the first, rad in (-pi, pi].
  [[nodiscard]] double placeOf(std::size_t planet) const;
  /// Distance of the planets' axis from the central one, and the largest tip radius; 0 for groups of several
  /// links.
  [[nodiscard]] std::pair<double, double> orbitAndTip() const;

 private:
  [[nodiscard]] const TrainMesh& meshOf(std::size_t planet, std::size_t which) const {
    const MeshOrdinal mesh = m_planets[planet].meshes[which];
    return m_train.meshes[static_cast<std::size_t>(m_meshAt[static_cast<std::size_t>(mesh)])];
  }
  [[nodiscard]] bool isOwn(GearOrdinal g) const {
    const std::vector<LinkOrdinal>& links = m_planets.front().links;
    return std::find(links.begin(), links.end(), gear(g).link) != links.end();
  }
  bool findGears();
  [[nodiscard]] Eigen::Vector3d axisOf(const EqualLinks& of, std::size_t planet) const;
  [[nodiscard]] double markAngle(const EqualLinks& of, std::size_t planet, std::size_t which) const;
  [[nodiscard]] PhaseWheel wheel(GearOrdinal g) const {
    const Eigen::Isometry3d& pose = gear(g).pose;
    return phaseWheelOf(gear(g).spec, pose.translation(), pose.linear().col(2), pose.linear().col(0));
  }
  [[nodiscard]] std::vector<Tie> tiesOf(GearOrdinal g, const Eigen::Vector3d& axis) const;
  /// The mesh of the first planet with a gear outside of it that the others' places are compared by.
  [[nodiscard]] std::pair<std::size_t, GearOrdinal> centralMesh() const;

  const GearTrain& m_train;
  const std::vector<int>& m_meshAt;
  const std::vector<PlanetGroup>& m_planets;
  std::vector<EqualLinks> m_links;
  bool m_isSound = false;
};

bool PlanetSet::findGears() {
  for (std::size_t l = 0; l < m_planets.front().links.size(); ++l) {
    EqualLinks same;
    for (const PlanetGroup& planet : m_planets) same.links.push_back(planet.links[l]);
    same.gears.resize(m_planets.size());
    m_links.push_back(std::move(same));
  }
  for (std::size_t which = 0; which < m_planets.front().meshes.size(); ++which) {
    for (std::size_t p = 0; p < m_planets.size(); ++p) {
      const MeshOrdinal mesh = m_planets[p].meshes[which];
      if (m_meshAt[static_cast<std::size_t>(mesh)] < 0) return false;
      if (std::abs(meshOf(p, which).residual) > kPhaseFits) return false;
    }
    for (EqualLinks& same : m_links) {
      const auto end = [&](std::size_t p) -> GearOrdinal {
        const TrainMesh& mesh = meshOf(p, which);
        if (gear(mesh.tailGear).link == same.links[p]) return mesh.tailGear;
        return gear(mesh.headGear).link == same.links[p] ? mesh.headGear : GearOrdinal(-1);
      };
      const GearOrdinal first = end(0);
      if (first < 0) continue;
      const auto known = std::find(same.gears[0].begin(), same.gears[0].end(), first);
      const auto at = static_cast<std::size_t>(known - same.gears[0].begin());
      for (std::size_t p = 0; p < m_planets.size(); ++p) {
        const GearOrdinal g = end(p);
        if (g < 0) return false;
        if (at < same.gears[p].size() ? same.gears[p][at] != g : at > same.gears[p].size()) return false;
        if (at == same.gears[p].size()) same.gears[p].push_back(g);
      }
    }
  }
  return true;
}

/// The axis of the link's gears, in corresponding sense for all planets: from the apex for bevels, else as
/// that of the first planet.
Eigen::Vector3d PlanetSet::axisOf(const EqualLinks& of, std::size_t planet) const {
  const Gears& gears = of.gears[planet];
  for (const GearOrdinal g : gears)
    if (isConical(gear(g).spec)) return wheel(g).axis;
  const Eigen::Vector3d own = wheel(gears.front()).axis;
  return own.dot(wheel(of.gears.front().front()).axis) < 0 ? Eigen::Vector3d(-own) : own;
}

double PlanetSet::markAngle(const EqualLinks& of, std::size_t planet, std::size_t which) const {
  const Eigen::Vector3d axis = axisOf(of, planet);
  const Eigen::Vector3d zero = axis.unitOrthogonal();
  const Eigen::Vector3d mark = wheel(of.gears[planet][which]).mark;
  return std::atan2(zero.cross(mark).dot(axis), zero.dot(mark));
}

std::pair<std::size_t, GearOrdinal> PlanetSet::centralMesh() const {
  for (std::size_t which = 0; which < m_planets.front().meshes.size(); ++which) {
    const TrainMesh& mesh = meshOf(0, which);
    for (const GearOrdinal g : {mesh.tailGear, mesh.headGear})
      if (!isOwn(g)) return {which, g};
  }
  return {0, -1};
}

double PlanetSet::placeOf(std::size_t planet) const {
  const auto [which, central] = centralMesh();
  const PhaseWheel about = wheel(central);
  const auto across = [&](std::size_t p) -> Eigen::Vector3d {
    const Eigen::Vector3d arm = meshOf(p, which).pitchPoint - about.centre;
    return arm - arm.dot(about.axis) * about.axis;
  };
  const Eigen::Vector3d first = across(0);
  const Eigen::Vector3d own = across(planet);
  return std::atan2(first.cross(own).dot(about.axis), first.dot(own));
}

std::pair<double, double> PlanetSet::orbitAndTip() const {
  const GearOrdinal central = centralMesh().second;
  if (m_links.size() != 1 || central < 0) return {0, 0};
  double tip = 0;
  for (const GearOrdinal g : m_links.front().gears.front()) {
    if (!isDisc(gear(g).spec)) return {0, 0};
    tip = std::max(tip, nominalTipRadius(gear(g).spec));
  }
  const PhaseWheel planet = wheel(m_links.front().gears.front().front());
  const PhaseWheel about = wheel(central);
  return {(planet.centre - about.centre).cross(about.axis).norm(), tip};
}

/// Turning carrier and planet by an angle is turning the central gears backwards under a planet that stays;
/// its gears then roll by as many pitches as the central gear passes.
std::vector<Tie> PlanetSet::tiesOf(GearOrdinal g, const Eigen::Vector3d& axis) const {
  struct Reached {
    GearOrdinal gear;
    int sense;  ///< pitches that pass it for one of g
  };
  const GearOrdinal centre = centralMesh().second;
  const Eigen::Vector3d about = wheel(centre).axis;
  const double own = wheel(g).axis.dot(axis) < 0 ? -1 : 1;
  std::vector<Tie> ties;
  std::vector<Reached> queue{{g, 1}};
  for (std::size_t q = 0; q < queue.size(); ++q) {
    const Reached from = queue[q];
    for (std::size_t which = 0; which < m_planets.front().meshes.size(); ++which) {
      const TrainMesh& mesh = meshOf(0, which);
      if (mesh.tailGear != from.gear && mesh.headGear != from.gear) continue;
      const GearOrdinal other = mesh.tailGear == from.gear ? mesh.headGear : mesh.tailGear;
      const int sense = from.sense * meshPhase(wheel(from.gear), wheel(other), mesh.pitchPoint).sign;
      const auto isOther = [other](const Reached& each) { return each.gear == other; };
      if (isOwn(other)) {
        if (std::none_of(queue.begin(), queue.end(), isOther)) queue.push_back({other, sense});
      } else if (gear(other).axisGroup == gear(centre).axisGroup) {
        const double backwards = wheel(other).axis.dot(about) < 0 ? 1 : -1;
        ties.push_back(
            {gear(g).spec.teeth, own * sense * backwards * gear(other).spec.teeth / gear(g).spec.teeth});
      }
    }
  }
  return ties;
}

std::int64_t PlanetSet::places() const {
  constexpr double kMaxPlaces = 1e15;
  if (centralMesh().second < 0) return 0;
  std::int64_t common = 0;
  for (const EqualLinks& same : m_links) {
    if (same.gears.front().empty()) continue;
    const Eigen::Vector3d axis = axisOf(same, 0);
    std::vector<Tie> ties;
    for (const GearOrdinal g : same.gears.front()) {
      const std::vector<Tie> more = tiesOf(g, axis);
      ties.insert(ties.end(), more.begin(), more.end());
    }
    for (std::size_t i = 0; i < ties.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const double step = std::lcm(std::int64_t{ties[i].teeth}, std::int64_t{ties[k].teeth});
        const double steps = step * std::abs(ties[i].turnsPer - ties[k].turnsPer);
        if (steps > kMaxPlaces) return 0;
        common = std::gcd(common, std::int64_t{std::llround(steps)});
      }
    }
  }
  return common;
}

/// What has to differ between the same link of equal planets.
struct TurnDifference {
  int teeth = 0;       ///< of the two gears
  int otherTeeth = 0;  //
  std::vector<double>
      turns;  ///< by planet: of the second gear against the first, beyond that of planet 0, rad
  [[nodiscard]] bool any() const {
    return std::any_of(turns.begin(), turns.end(), [](double turn) { return turn != 0; });
  }
};

TurnDifference differenceOf(const PlanetSet& set, DisjointSets& tied, const EqualLinks& same, std::size_t one,
                            std::size_t other) {
  TurnDifference difference{set.gear(same.gears[0][one]).spec.teeth,
                            set.gear(same.gears[0][other]).spec.teeth,
                            std::vector<double>(same.links.size(), 0)};
  const double most = std::max(difference.teeth, difference.otherTeeth);
  const double step = kTurn / static_cast<double>(std::lcm(std::int64_t{difference.teeth},
                                                           std::int64_t{difference.otherTeeth}));
  for (std::size_t p = 1; p < same.links.size(); ++p) {
    const bool isFree = !tied.areJoined(same.gears[0][one], same.gears[p][one]) ||
                        !tied.areJoined(same.gears[0][other], same.gears[p][other]);
    if (isFree) continue;
    const double turn = set.turnOf(same, p, other) - set.turnOf(same, p, one);
    const double left = turn - step * std::round(turn / step);
    if (std::abs(left) * most / kTurn > kPhaseFits) difference.turns[p] = left;
  }
  return difference;
}

std::string linkName(const Mechanism& mechanism, LinkOrdinal link) {
  return std::to_string(mechanism.linkLabel(link));
}

/// Positions and numbers of planets that fit.
std::string adviceFor(const Mechanism& mechanism, const PlanetSet& set, const EqualLinks& same) {
  const std::int64_t places = set.places();
  if (places == 0) return {};
  const double pitch = kTurn / static_cast<double>(places);
  if (places < static_cast<std::int64_t>(same.links.size()))
    return ' ' + translated(
                     "With these teeth there are fewer places for equal planets (%1) than planets: let the "
                     "planets differ, or change tooth counts.",
                     {std::to_string(places)});
  std::vector<std::string> moves;
  for (std::size_t p = 1; p < same.links.size(); ++p) {
    const double place = set.placeOf(p);
    const double move = pitch * std::round(place / pitch) - place;
    if (std::abs(move) < kPhaseFits * pitch) continue;
    moves.push_back(translated("link %1 by %2 degrees",
                               {linkName(mechanism, same.links[p]), fixedText(move / kDegree, 3)}));
  }
  if (moves.empty()) return {};
  std::string text =
      ' ' + translated(
                "Equal planets fit at multiples of 360/%1 = %2 degrees: move the axis of %3 round "
                "the central axis",
                {std::to_string(places), fixedText(pitch / kDegree, 3), listed(moves, kMaxPlanetNames)});
  const auto [orbit, tip] = set.orbitAndTip();
  const int count = nearestPlanetCount(static_cast<int>(same.links.size()), places, orbit, tip);
  if (count > 0) text += translated(", or use %1 planets at equal distances", {std::to_string(count)});
  return text + ".";
}

Diagnostic unequalPlanets(const Mechanism& mechanism, const PlanetSet& set, const EqualLinks& same,
                          const TurnDifference& difference) {
  std::vector<std::string> planets;
  std::vector<std::string> turns;
  std::vector<ElementId> elements;
  for (std::size_t p = 0; p < same.links.size(); ++p) {
    planets.push_back(linkName(mechanism, same.links[p]));
    elements.emplace_back(mechanism.links[same.links[p]].id);
    if (difference.turns[p] == 0) continue;
    turns.push_back(
        translated("%1 degrees on link %2", {fixedText(difference.turns[p] / kDegree, 3), planets.back()}));
  }
  const std::string message = translated(
      "Links %1 are drawn as equal planets and cannot be equal parts: with all teeth in mesh, their gear "
      "with "
      "%2 teeth is turned against that with %3 teeth, compared with link %4, by %5.",
      {listed(planets, kMaxPlanetNames), std::to_string(difference.otherTeeth),
       std::to_string(difference.teeth), planets.front(), listed(turns, kMaxPlanetNames)});
  return makeDiagnostic(Detail::unequalPlanets, message + adviceFor(mechanism, set, same),
                        std::move(elements));
}

}  // namespace

int nearestPlanetCount(int count, std::int64_t places, double orbit, double tip) {
  if (orbit <= 0 || places <= 0) return 0;
  for (int step = 1; step < 2 * count; ++step) {
    const int other = count + (step % 2 == 1 ? 1 : -1) * ((step + 1) / 2);
    if (other < 2 || places % other != 0) continue;
    if (orbit * std::sin(std::numbers::pi / other) > tip) return other;
  }
  return 0;
}

Diagnostics planetDiagnostics(const Mechanism& mechanism, const Placement& placement, const GearTrain& train,
                              const std::stop_token& stop) {
  Diagnostics found;
  std::vector<int> meshAt(mechanism.gearMeshes.size(), -1);
  for (std::size_t m = 0; m < train.meshes.size(); ++m)
    meshAt[static_cast<std::size_t>(train.meshes[m].mesh)] = static_cast<int>(m);
  DisjointSets tied = tiedGears(train);
  for (const std::vector<PlanetGroup>& planets : equalPlanets(mechanism, placement, PlanetScope::all)) {
    if (stop.stop_requested()) return found;
    const PlanetSet set(train, meshAt, planets);
    if (!set.isSound()) continue;
    for (const EqualLinks& same : set.links()) {
      for (std::size_t other = 1; other < same.gears.front().size(); ++other) {
        const TurnDifference difference = differenceOf(set, tied, same, 0, other);
        if (difference.any()) found.push_back(unequalPlanets(mechanism, set, same, difference));
      }
    }
  }
  return found;
}

}  // namespace geargraph
