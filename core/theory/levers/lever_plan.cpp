#include "core/theory/levers/lever_plan.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/foundations/exact/elimination.h"
#include "core/foundations/exact/fields.h"
#include "core/theory/levers/residue_field.h"
#include "core/theory/states/relative_speed.h"

namespace geargraph {
namespace {

using Coordinates = std::vector<Rational>;

/// The rows of meshes and held couplings; those whose mark in `left` is not 0 are left out.
template <class Field, class Weights>
SparseRows<typename Field::Value> leverRows(const KinematicModel& model,
                                            std::span<const KinematicModel::HeldRow> held, const Field& field,
                                            const Weights& weights, const std::vector<char>& left) {
  SparseRows<typename Field::Value> rows;
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh) {
    if (left[static_cast<std::size_t>(int{mesh})] != 0) continue;
    model.addMeshRow(rows, mesh, field, weights(mesh, true), weights(mesh, false));
    rows.endRow();
  }
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (left[static_cast<std::size_t>(model.c()) + i] != 0) continue;
    KinematicModel::addHeldRow(rows, held[i], field);
    rows.endRow();
  }
  return rows;
}

/// The points of the train for random tooth counts, as seen in two random motions: three points that are on
/// one line there are on one for all tooth counts, but for a probability near 2^-60.
class GeneralPosition {
 public:
  /// Nothing where `stop` was requested.
  static std::optional<GeneralPosition> of(const KinematicModel& model,
                                           std::span<const KinematicModel::HeldRow> held,
                                           const std::vector<char>& left, const std::stop_token& stop) {
    GeneralPosition general;
    const PrimeField& prime = general.m_field.prime();
    ResidueStream random(prime, 0x6c65766572U);
    const auto weights = [&](MeshOrdinal, bool) { return random.next(); };
    const auto system = eliminate(general.m_field, leverRows(model, held, general.m_field, weights, left),
                                  model.n(), model.n(), stop);
    if (!system) return std::nullopt;
    for (auto& motion : general.m_motions) {
      motion.assign(static_cast<std::size_t>(model.n()), 0);
      for (const int column : system->freeColumns) motion[static_cast<std::size_t>(column)] = random.next();
      substitute(general.m_field, *system, std::span(motion));
    }
    return general;
  }

  [[nodiscard]] bool coincide(LinkOrdinal a, LinkOrdinal b) const {
    return at(a, 0) == at(b, 0) && at(a, 1) == at(b, 1);
  }
  [[nodiscard]] bool areOnOneLine(LinkOrdinal a, LinkOrdinal b, LinkOrdinal c) const {
    const PrimeField& prime = m_field.prime();
    const auto to = [&](LinkOrdinal link, int motion) {
      return prime.subtract(at(link, motion), at(a, motion));
    };
    return prime.multiply(to(b, 0), to(c, 1)) == prime.multiply(to(b, 1), to(c, 0));
  }

 private:
  [[nodiscard]] PrimeField::Residue at(LinkOrdinal link, int motion) const {
    const auto& speeds = m_motions[static_cast<std::size_t>(motion)];
    return link == 0 ? 0 : speeds[static_cast<std::size_t>(link) - 1];
  }

  ResidueField m_field;
  std::array<std::vector<PrimeField::Residue>, 2> m_motions;
};

/// Brings the coordinates to a basis of links: the first links that are independent have unit coordinates.
/// Gauss-Jordan elimination of the columns, link by link. False where `stop` was requested.
bool changeToLinks(const std::vector<LinkOrdinal>& links, std::vector<Coordinates>& points,
                   std::vector<LinkOrdinal>& basis, const std::stop_token& stop) {
  const std::size_t width = points.empty() ? 0 : points.front().size();
  for (std::size_t i = 0; i < points.size() && basis.size() < width; ++i) {
    if (stop.stop_requested()) return false;
    const std::size_t place = basis.size();
    std::size_t pivot = place;
    while (pivot < width && points[i][pivot].isZero()) ++pivot;
    if (pivot == width) continue;
    const Rational scale = points[i][pivot].inverse();
    for (Coordinates& point : points) {
      std::swap(point[place], point[pivot]);
      if (!point[place].isZero()) point[place] *= scale;
    }
    for (std::size_t column = 0; column < width; ++column) {
      const Rational factor = points[i][column];
      if (column == place || factor.isZero()) continue;
      for (Coordinates& point : points) {
        if (!point[place].isZero()) point[column] -= factor * point[place];
      }
    }
    basis.push_back(links[i]);
  }
  return true;
}

/// The direction from one point to another, scaled so that its first coordinate that is not 0 is 1.
Coordinates directionBetween(const Coordinates& from, const Coordinates& to) {
  Coordinates direction(from.size());
  std::optional<Rational> scale;
  for (std::size_t k = 0; k < from.size(); ++k) {
    if (from[k] == to[k]) continue;
    direction[k] = to[k] - from[k];
    if (!scale) scale = direction[k].inverse();
    direction[k] *= *scale;
  }
  return direction;
}

/// Finds the lines through three or more of the plan's points.
class LineFinder {
 public:
  LineFinder(LeverPlan& plan, const GeneralPosition& general) : m_plan(plan), m_general(general) {
    std::map<Coordinates, std::size_t> known;
    for (std::size_t i = 0; i < plan.links.size(); ++i) {
      const auto [at, isNew] = known.emplace(plan.points[i], m_places.size());
      if (isNew) m_places.push_back({plan.points[i], {}});
      m_places[at->second].links.push_back(plan.links[i]);
    }
  }

  /// False where `stop` was requested.
  bool find(const std::stop_token& stop) {
    std::vector<std::vector<char>> isJoined(m_places.size(), std::vector<char>(m_places.size(), 0));
    for (std::size_t i = 0; i < m_places.size(); ++i) {
      std::map<Coordinates, std::vector<std::size_t>> others;
      for (std::size_t j = i + 1; j < m_places.size(); ++j) {
        if (stop.stop_requested()) return false;
        if (isJoined[i][j] == 0) others[directionBetween(m_places[i].at, m_places[j].at)].push_back(j);
      }
      for (auto& [direction, line] : others) {
        if (line.size() < 2) continue;
        line.insert(line.begin(), i);
        for (const std::size_t a : line) {
          for (const std::size_t b : line) isJoined[a][b] = 1;
        }
        m_plan.levers.push_back(leverThrough(line));
      }
    }
    return true;
  }

 private:
  struct Place {
    Coordinates at;
    std::vector<LinkOrdinal> links;
  };

  [[nodiscard]] Lever leverThrough(const std::vector<std::size_t>& line) const {
    const Coordinates& origin = m_places[line[0]].at;
    const Coordinates& other = m_places[line[1]].at;
    std::size_t k = 0;
    while (origin[k] == other[k]) ++k;
    Lever lever;
    for (const std::size_t place : line)
      lever.points.push_back({m_places[place].links, m_places[place].at[k] - origin[k]});
    std::sort(lever.points.begin(), lever.points.end(),
              [](const LeverPoint& a, const LeverPoint& b) { return a.at < b.at; });
    if (lever.points.back().links.front() < lever.points.front().links.front())
      std::reverse(lever.points.begin(), lever.points.end());
    const Rational first = lever.points.front().at;
    const Rational span = lever.points.back().at - first;
    for (LeverPoint& point : lever.points) point.at = (point.at - first) / span;
    markAccidental(lever);
    return lever;
  }

  /// The most points that are on one line for all tooth counts stay marked as such.
  void markAccidental(Lever& lever) const {
    std::vector<LeverPoint>& points = lever.points;
    const auto link = [&](std::size_t i) { return points[i].links.front(); };
    std::vector<char> best(points.size(), 0);
    std::ptrdiff_t most = 2;
    for (std::size_t a = 0; a < points.size(); ++a) {
      for (std::size_t b = a + 1; b < points.size() && most < std::ssize(points); ++b) {
        if (m_general.coincide(link(a), link(b))) continue;
        std::vector<char> on(points.size(), 0);
        for (std::size_t c = 0; c < points.size(); ++c)
          on[c] = m_general.areOnOneLine(link(a), link(b), link(c)) ? 1 : 0;
        const auto count = std::count(on.begin(), on.end(), char{1});
        if (count > most) {
          most = count;
          best = on;
        }
      }
    }
    lever.isByMeshes = most >= 3;
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i].isByMeshes = best[i] != 0;
      points[i].isOneByMeshes =
          std::all_of(points[i].links.begin(), points[i].links.end(),
                      [&](LinkOrdinal each) { return m_general.coincide(each, link(i)); });
    }
  }

  LeverPlan& m_plan;
  const GeneralPosition& m_general;
  std::vector<Place> m_places;  ///< different points, by their first links
};

/// The first mesh from a wheel on the main axis to one whose axis points elsewhere.
std::optional<MeshOrdinal> meshAway(const Placement& placement, AxisGroupOrdinal mainAxis) {
  for (const MeshOrdinal mesh : placement.meshes.ordinals()) {
    const MeshGeometry& geometry = *placement.meshes[mesh];
    const bool isMain = geometry.tailClass == mainAxis || geometry.headClass == mainAxis;
    if (isMain && directionSign(placement, geometry.tailClass, geometry.headClass) == 0) return mesh;
  }
  return std::nullopt;
}

/// Tells the groups of each lever, and brings levers into the order of their meshes.
void assignGroups(LeverPlan& plan) {
  for (Lever& lever : plan.levers) {
    for (std::size_t group = 0; group < plan.groups.size(); ++group) {
      const auto& links = plan.groups[group].links;
      if (links.size() >= 2 && std::all_of(links.begin(), links.end(),
                                           [&](LinkOrdinal link) { return lever.pointOf(link) != nullptr; }))
        lever.groups.push_back(static_cast<int>(group));
    }
  }
  const auto rank = [&](const Lever& lever) {
    return lever.groups.empty() ? static_cast<int>(plan.groups.size()) : lever.groups.front();
  };
  std::stable_sort(plan.levers.begin(), plan.levers.end(),
                   [&](const Lever& a, const Lever& b) { return rank(a) < rank(b); });
}

LeverAbsence absenceOf(const LeverPlan& plan) {
  if (!plan.levers.empty()) return LeverAbsence::none;
  const bool isAtRest = std::all_of(plan.points.begin(), plan.points.end(), [](const Coordinates& point) {
    return std::all_of(point.begin(), point.end(), [](const Rational& each) { return each.isZero(); });
  });
  if (isAtRest && plan.links.size() > 1) return LeverAbsence::locked;
  return plan.turningAway ? LeverAbsence::directions : LeverAbsence::noMesh;
}

/// The points in the coordinates of the free columns of an elimination.
std::vector<Coordinates> pointsOf(const std::vector<LinkOrdinal>& links,
                                  const Elimination<Rational>& system) {
  std::vector<Coordinates> points(links.size());
  std::vector<Rational> phi;
  for (const int column : system.freeColumns) {
    phi.assign(static_cast<std::size_t>(system.columns), Rational(0));
    phi[static_cast<std::size_t>(column)] = 1;
    substitute(RationalField(), system, std::span(phi));
    for (std::size_t i = 0; i < links.size(); ++i)
      points[i].push_back(links[i] == 0 ? Rational(0) : phi[static_cast<std::size_t>(links[i]) - 1]);
  }
  return points;
}

}  // namespace

const LeverPoint* Lever::pointOf(LinkOrdinal link) const {
  for (const LeverPoint& point : points) {
    if (std::binary_search(point.links.begin(), point.links.end(), link)) return &point;
  }
  return nullptr;
}

int LeverPlan::positionOf(LinkOrdinal link) const {
  const auto found = std::lower_bound(links.begin(), links.end(), link);
  return found != links.end() && *found == link ? static_cast<int>(found - links.begin()) : -1;
}

std::vector<std::vector<LinkOrdinal>> LeverPlan::coincident() const {
  std::map<Coordinates, std::vector<LinkOrdinal>> places;
  for (std::size_t i = 0; i < links.size(); ++i) places[points[i]].push_back(links[i]);
  std::vector<std::vector<LinkOrdinal>> shared;
  for (auto& [point, all] : places) {
    if (all.size() > 1) shared.push_back(std::move(all));
  }
  std::sort(shared.begin(), shared.end());
  return shared;
}

bool LeverPlan::areOneByMeshes(const std::vector<LinkOrdinal>& shared) const {
  return std::all_of(levers.begin(), levers.end(), [&](const Lever& lever) {
    const LeverPoint* const point = lever.pointOf(shared.front());
    return point == nullptr || point->isOneByMeshes;
  });
}

AxisGroupOrdinal mainAxisOf(const Placement& placement) {
  const AxisGroups& classes = *placement.classes;
  std::vector<int> links(classes.classes.size(), 0);
  for (std::size_t link = 1; link < classes.ofLink.size(); ++link)
    ++links[static_cast<std::size_t>(int{classes.ofLink[LinkOrdinal(link)]})];
  AxisGroupOrdinal main = -1;
  for (const AxisGroupOrdinal each : classes.classes.ordinals()) {
    if (classes.classes[each].rootLink != 0) continue;
    if (main < 0 || links[static_cast<std::size_t>(int{each})] > links[static_cast<std::size_t>(int{main})])
      main = each;
  }
  return main;
}

std::optional<LeverPlan> leverPlanOf(const KinematicModel& model, const Placement& placement,
                                     std::span<const KinematicModel::HeldRow> held,
                                     const std::stop_token& stop) {
  LeverPlan plan;
  plan.mainAxis = mainAxisOf(placement);
  if (plan.mainAxis < 0) {
    plan.absence = LeverAbsence::noMesh;
    return plan;
  }
  for (LinkOrdinal link = 0; link <= model.n(); ++link) {
    if (isOnAxis(placement, plan.mainAxis, link)) plan.links.push_back(link);
  }
  const auto teeth = [&](MeshOrdinal mesh, bool tail) -> Rational {
    return tail ? model.meshRow(mesh).tailTeeth : model.meshRow(mesh).headTeeth;
  };
  std::vector<char> left(static_cast<std::size_t>(model.c()) + held.size(), 0);
  const auto system = eliminate(RationalField(), leverRows(model, held, RationalField(), teeth, left),
                                model.n(), model.n(), stop);
  if (!system) return std::nullopt;
  plan.freedom = static_cast<int>(system->freeColumns.size());
  plan.groups = meshGroups(placement, plan.mainAxis);
  plan.turningAway = meshAway(placement, plan.mainAxis);
  if (plan.links.size() > kMaxLeverLinks ||
      plan.links.size() * static_cast<std::size_t>(plan.freedom) > kMaxLeverCoordinates) {
    plan.absence = LeverAbsence::tooLarge;
    return plan;
  }
  plan.points = pointsOf(plan.links, *system);
  if (!changeToLinks(plan.links, plan.points, plan.basis, stop)) return std::nullopt;

  // Rows that depend on others do so for these teeth: without them the train is as free for any others.
  for (const auto& check : system->checks) left[static_cast<std::size_t>(check.source)] = 1;
  const auto general = GeneralPosition::of(model, held, left, stop);
  if (!general || !LineFinder(plan, *general).find(stop)) return std::nullopt;
  assignGroups(plan);
  plan.absence = absenceOf(plan);
  return plan;
}

}  // namespace geargraph
