#include "core/machine/body_layout/ground_frame.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/foundations/base/disjoint_sets.h"
#include "core/machine/body_layout/body_shapes.h"
#include "core/machine/body_layout/carrier_cases.h"
#include "core/machine/body_layout/swept_envelope.h"
#include "core/machine/solids/gear_body.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

// In modules.
constexpr double kBar = 1.0, kStoutBar = 1.4;        ///< radius of a bar across an axis; of a long one
constexpr double kColumn = 1.3, kStoutColumn = 2.4;  ///< radius of a column; of a long one
constexpr double kRim = 1.2 * kColumn;               ///< of the base about a column
constexpr double kPlay = 0.4;                        ///< between the frame and what sweeps past it
constexpr double kMaxHousingLength = 8.0;            ///< between two bearings
constexpr double kBaseThickness = 2.0;
constexpr double kAboveBase = 1.0;  ///< what sweeps over the base
constexpr int kDirections = 16;
constexpr std::size_t kMaxReaches = 16;

/// A part of the ground on an axis: an interval of it.
struct Piece {
  AxisGroupOrdinal axisGroup = 0;
  double low = 0, high = 0;
  double outer = 0;
  bool isBearing = false;
};

/// A ring of the ground, on whose rim a bar may stand.
struct Rim {
  AxisGroupOrdinal axisGroup = 0;
  double low = 0, high = 0;
  double inner = 0, outer = 0;
  int piece = -1;  ///< that holds the ring
};

/// One or two bars from a bearing.
struct Bracket {
  double length = 1e300;
  std::vector<FrameBar> bars;
  std::optional<HousingPlan> housing;
  std::optional<FramePlan::Foot> foot;
  int onto = -1;  ///< the piece that it stands on; -1: the base
};

class FrameMaker {
 public:
  FrameMaker(const Arrangement& plan, const GearTrain& train, std::vector<SweptEnvelope> envelopes)
      : m_plan(plan), m_train(train), m_envelopes(std::move(envelopes)) {}

  FramePlan make() {
    findPieces();
    if (m_pieces.empty()) return m_made;
    joinTouching();
    addHousings();
    std::vector<std::size_t> open = separatePieces();
    for (const std::size_t group : open) {
      if (separatePieces().size() < 2) break;
      if (const Bracket bracket = bestBracket(group, true); bracket.onto >= 0) use(group, bracket);
    }
    open = separatePieces();
    if (open.size() > 1) standOnBase(open);
    return std::move(m_made);
  }

 private:
  [[nodiscard]] const AxisLayout& axis(int c) const { return m_plan.axes[c]; }
  [[nodiscard]] double module() const { return m_plan.axes.front().module; }

  void findPieces();
  void findRims();
  void joinTouching();
  void addHousings();
  [[nodiscard]] std::optional<HousingPlan> housingBetween(const Piece& a, const Piece& b) const;
  void addHousing(HousingPlan housing);
  void standOnBase(const std::vector<std::size_t>& open);
  [[nodiscard]] double baseTop() const;
  [[nodiscard]] Bracket bestBracket(std::size_t group, bool onRims) const;
  void considerRims(const Piece& piece, Bracket& best) const;
  void considerBase(const Piece& piece, Bracket& best) const;
  void considerPedestal(const Piece& piece, Bracket& best) const;
  void use(std::size_t group, const Bracket& bracket);
  [[nodiscard]] bool isClear(const Vector3d& from, const Vector3d& to, double radius, const Piece* own) const;
  [[nodiscard]] std::vector<double> reachesFrom(const Piece& piece, const Vector3d& way) const;
  [[nodiscard]] std::optional<Bracket> bracketTo(const Piece& piece, const Vector3d& way, double reach,
                                                 bool isStout) const;
  [[nodiscard]] double stout(double slender, double most, double length) const {
    return std::clamp(length / 16, slender * module(), std::max(slender, most) * module());
  }

  // Pieces that hang together.
  [[nodiscard]] std::size_t rootOf(std::size_t piece) const { return m_joined.root(piece); }
  void join(std::size_t a, std::size_t b) { m_joined.join(a, b); }
  [[nodiscard]] std::vector<std::size_t> separatePieces() const {
    std::vector<std::size_t> roots;
    for (std::size_t p = 0; p < m_pieces.size(); ++p) {
      if (rootOf(p) == p) roots.push_back(p);
    }
    return roots;
  }
  /// The first piece on the axis that holds the coordinate; -1: none.
  [[nodiscard]] int pieceAt(int c, double coordinate) const {
    for (std::size_t p = 0; p < m_pieces.size(); ++p) {
      const double off = 1e-6 * module();
      if (m_pieces[p].axisGroup == c && m_pieces[p].low - off <= coordinate &&
          coordinate <= m_pieces[p].high + off)
        return static_cast<int>(p);
    }
    return -1;
  }

  const Arrangement& m_plan;
  const GearTrain& m_train;
  std::vector<SweptEnvelope> m_envelopes;
  std::vector<Piece> m_pieces;
  DisjointSets m_joined;  ///< of pieces
  std::vector<Rim> m_rims;
  FramePlan m_made;
};

void FrameMaker::findPieces() {
  for (std::size_t c = 0; c < m_plan.axes.size(); ++c) {
    const double half = m_plan.axes[c].width() / 2;
    for (const Bearing& b : m_plan.axes[c].bearings) {
      if (b.parent != 0 || !b.isBoss()) continue;
      const int on = static_cast<int>(c);
      m_pieces.push_back({on, b.at - half, b.at + half, bossRadius(m_plan, on, b), true});
    }
  }
  for (const ShaftSegment& s : m_plan.shafts) {
    if (s.link == 0) m_pieces.push_back({s.axisGroup, s.low, s.high, s.outer, false});
  }
  for (const PedestalPlan& pedestal : m_plan.pedestals) {
    const ShaftSegment* shaft = m_plan.shaftOf(pedestal.axisGroup, 0, pedestal.at);
    const double half = 0.45 * axis(pedestal.axisGroup).width();
    if (shaft != nullptr)
      m_pieces.push_back({pedestal.axisGroup, pedestal.at - half, pedestal.at + half,
                          shaft->outer + bossWall(axis(pedestal.axisGroup)), true});
  }
  for (const RevolvedPlan& revolved : m_plan.revolvedBodies) {
    if (revolved.link != 0) continue;
    for (const auto& profile : revolved.profiles) {
      Piece piece{revolved.axisGroup, 1e300, -1e300, 0, false};
      for (const ProfileVertex& vertex : profile) {
        piece.low = std::min(piece.low, vertex.height);
        piece.high = std::max(piece.high, vertex.height);
        piece.outer = std::max(piece.outer, vertex.radius);
      }
      m_pieces.push_back(piece);
    }
  }
  m_joined = DisjointSets(m_pieces.size());
  findRims();
}

/// Rings of the ground, and rings without anything else, as pieces of their own.
void FrameMaker::findRims() {
  for (const TrainGear& gear : m_train.gears) {
    if (gear.link != 0 || !isRing(gear.spec)) continue;
    const AxisLayout& on = axis(gear.axisGroup);
    const double middle = on.coordinate(gear.pose.translation()), half = gear.spec.faceWidth / 2;
    Rim rim{gear.axisGroup, middle - half, middle + half,
            nominalRootRadius(gear.spec) + 0.4 * gear.spec.module, rimDiameter(gear.spec) / 2};
    for (const RingCarrierPlan& ringCarrier : m_plan.ringCarriers) {
      if (&m_train.gears[ringCarrier.gear] == &gear) rim.piece = pieceAt(gear.axisGroup, ringCarrier.plate);
    }
    if (rim.piece < 0) {
      rim.piece = static_cast<int>(m_pieces.size());
      m_joined.add();
      m_pieces.push_back({gear.axisGroup, rim.low, rim.high, rim.outer, false});
    }
    m_rims.push_back(rim);
  }
}

/// What overlaps on one axis, and what the ground's arms join.
void FrameMaker::joinTouching() {
  for (std::size_t a = 0; a < m_pieces.size(); ++a) {
    for (std::size_t b = a + 1; b < m_pieces.size(); ++b) {
      const Piece& one = m_pieces[a];
      const Piece& other = m_pieces[b];
      if (one.axisGroup == other.axisGroup &&
          axis(one.axisGroup).overlap(one.low, one.high, other.low, other.high))
        join(a, b);
    }
  }
  for (const ArmPlan& arm : m_plan.arms) {
    if (arm.link != 0) continue;
    const int from = pieceAt(arm.from, arm.level), to = pieceAt(arm.to, arm.at);
    if (from >= 0 && to >= 0) join(static_cast<std::size_t>(from), static_cast<std::size_t>(to));
  }
}

/// A tube about the shafts between two bearings, where nothing else is in its room.
std::optional<HousingPlan> FrameMaker::housingBetween(const Piece& a, const Piece& b) const {
  const AxisLayout& on = axis(a.axisGroup);
  const double low = a.high, high = b.low;
  if (high - low > kMaxHousingLength * on.module) return std::nullopt;
  double inside = 0;
  for (const ShaftSegment& s : m_plan.shafts) {
    if (s.axisGroup == a.axisGroup && s.link != 0 && on.overlap(s.low, s.high, a.low, b.high))
      inside = std::max(inside, s.outer);
  }
  HousingPlan housing{a.axisGroup, (a.low + a.high) / 2, (b.low + b.high) / 2, inside + bossClearance(on),
                      std::max({a.outer, b.outer, inside + bossClearance(on) + 0.6 * bossWall(on)})};
  housing.outer -= 0.1 * on.module;
  const double margin = housing.outer + kPlay * on.module;
  const bool areNeighbours = !on.isBelow(2 * on.gap(), high - low);  // no room for anything but shafts
  const bool isOccupied = std::any_of(m_envelopes.begin(), m_envelopes.end(), [&](const SweptEnvelope& e) {
    const bool isShaft = e.isOnAxis && e.kind == HullKind::shaft;
    if (e.axisGroup == a.axisGroup && (e.isOnAxis || !areNeighbours))
      return on.overlap(e.low, e.high, low, high) && e.inner < margin && !isShaft;
    if (areNeighbours) return false;
    return e.isNear(on.at(low), on.at(high), margin);
  });
  return isOccupied ? std::nullopt : std::optional(housing);
}

/// Housings that would meet in the middle of a bearing are one, or reach into each other: solids of one body
/// that share an edge are no closed surface.
void FrameMaker::addHousing(HousingPlan housing) {
  if (!m_made.housings.empty()) {
    HousingPlan& last = m_made.housings.back();
    if (last.axisGroup == housing.axisGroup && last.high == housing.low) {
      if (last.inner == housing.inner && last.outer == housing.outer) {
        last.high = housing.high;
        return;
      }
      housing.low -= 0.1 * axis(housing.axisGroup).module;
    }
  }
  m_made.housings.push_back(housing);
}

void FrameMaker::addHousings() {
  std::vector<std::size_t> order;
  for (std::size_t p = 0; p < m_pieces.size(); ++p) {
    if (m_pieces[p].isBearing) order.push_back(p);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Piece& x = m_pieces[a];
    const Piece& y = m_pieces[b];
    return x.axisGroup != y.axisGroup ? x.axisGroup < y.axisGroup : x.low < y.low;
  });
  for (std::size_t i = 0; i + 1 < order.size(); ++i) {
    const Piece& one = m_pieces[order[i]];
    const Piece& next = m_pieces[order[i + 1]];
    if (one.axisGroup != next.axisGroup || rootOf(order[i]) == rootOf(order[i + 1])) continue;
    const auto housing = housingBetween(one, next);
    if (!housing) continue;
    addHousing(*housing);
    join(order[i], order[i + 1]);
  }
}

double FrameMaker::baseTop() const {
  const Vector3d up = Vector3d::UnitZ();
  double top = 1e300;
  for (const SweptEnvelope& e : m_envelopes) top = std::min(top, e.lowestAlong(up));
  for (const Piece& piece : m_pieces) {
    const AxisLayout& on = axis(piece.axisGroup);
    SweptEnvelope own;
    own.point = on.point;
    own.direction = on.direction;
    own.low = piece.low;
    own.high = piece.high;
    own.outer = piece.outer;
    top = std::min(top, own.lowestAlong(up));
  }
  return top - kAboveBase * module();
}

/// Does a bar stay clear of everything that moves? `own`: the bearing that it starts at, whose shafts run
/// inside of it.
bool FrameMaker::isClear(const Vector3d& from, const Vector3d& to, double radius, const Piece* own) const {
  const double margin = radius + kPlay * module();
  return std::none_of(m_envelopes.begin(), m_envelopes.end(), [&](const SweptEnvelope& e) {
    if (own != nullptr && e.isOnAxis && e.axisGroup == own->axisGroup && e.kind == HullKind::shaft &&
        e.outer < own->outer)
      return false;
    return e.isNear(from, to, margin);
  });
}

/// How far out a column may be to pass what sweeps about parallel axes, ascending.
std::vector<double> FrameMaker::reachesFrom(const Piece& piece, const Vector3d& way) const {
  const AxisLayout& on = axis(piece.axisGroup);
  const double margin = (kColumn + kPlay + 0.1) * module();
  std::vector<double> reaches{piece.outer + 3 * module()};
  for (const SweptEnvelope& e : m_envelopes) {
    Vector3d apart = e.point - on.point;
    apart -= apart.dot(e.direction) * e.direction;
    const Vector3d along = way - way.dot(e.direction) * e.direction;
    const double square = along.squaredNorm();
    if (square < 0.01) continue;
    // |reach * along - apart| = outer + margin
    const double half = along.dot(apart) / square;
    const double rest =
        half * half - (apart.squaredNorm() - (e.outer + margin) * (e.outer + margin)) / square;
    if (rest >= 0 && half + std::sqrt(rest) > reaches.front()) reaches.push_back(half + std::sqrt(rest));
  }
  std::sort(reaches.begin(), reaches.end());
  const auto same = [&](double a, double b) { return std::abs(a - b) < 0.5 * module(); };
  reaches.erase(std::unique(reaches.begin(), reaches.end(), same), reaches.end());
  if (reaches.size() > kMaxReaches) reaches.erase(reaches.begin(), reaches.end() - kMaxReaches);
  return reaches;
}

/// Over the face of a ring about the same axis, and onto its rim.
void FrameMaker::considerRims(const Piece& piece, Bracket& best) const {
  const AxisLayout& on = axis(piece.axisGroup);
  const double at = (piece.low + piece.high) / 2;
  const Eigen::Isometry3d frame = frameAlong(on.at(at), on.direction, Vector3d::UnitY());
  for (const Rim& rim : m_rims) {
    if (rim.axisGroup != piece.axisGroup || rootOf(static_cast<std::size_t>(rim.piece)) ==
                                                rootOf(static_cast<std::size_t>(&piece - m_pieces.data())))
      continue;
    const double radius = std::min(kColumn * module(), (rim.outer - rim.inner) / 2);
    const double reach = (rim.inner + rim.outer) / 2;
    const double end = (rim.low + rim.high) / 2, face = at < end ? rim.low : rim.high;
    const double length = reach + std::abs(end - at);
    if (length >= best.length || (rim.low < at && at < rim.high)) continue;
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2 * std::numbers::pi * i / kDirections;
      const Vector3d way = frame.linear() * Vector3d(std::cos(angle), std::sin(angle), 0);
      const Vector3d start = on.at(at) + (piece.outer - 0.5 * bossWall(on)) * way;
      const Vector3d corner = on.at(at) + reach * way;
      const double beyond = (at < end ? -1 : 1) * 1.2 * radius;
      if (!isClear(start, corner, kBar * module(), &piece) ||
          !isClear(on.at(at + beyond) + reach * way, on.at(face) + reach * way, radius, nullptr))
        continue;
      const double wide = stout(kBar, std::min(kStoutBar, 1.2 * radius / module()), reach);
      const double bar = isClear(start, corner, wide, &piece) ? wide : kBar * module();
      best = {length,
              {{start, corner, bar}, {on.at(at + beyond) + reach * way, on.at(end) + reach * way, radius}},
              {},
              {},
              rim.piece};
      break;
    }
  }
}

/// A housing from a bearing on an upright axis down to the base.
void FrameMaker::considerPedestal(const Piece& piece, Bracket& best) const {
  const AxisLayout& on = axis(piece.axisGroup);
  if (std::abs(on.direction.z()) < 1 - 1e-9) return;
  const double sense = on.direction.z() < 0 ? -1 : 1;
  const double near = (piece.low + piece.high) / 2;
  const double far = on.coordinate({on.point.x(), on.point.y(), m_made.top - 0.5 * m_made.thickness});
  const double length = std::abs(near - far);
  if (length >= best.length) return;
  double inside = 0;
  for (const ShaftSegment& s : m_plan.shafts) {
    if (s.axisGroup == piece.axisGroup && on.overlap(s.low, s.high, std::min(near, far), std::max(near, far)))
      inside = std::max(inside, s.outer);
  }
  HousingPlan housing{piece.axisGroup, std::min(near, far), std::max(near, far), inside + bossClearance(on),
                      piece.outer - 0.1 * on.module};
  if (housing.inner + 0.4 * bossWall(on) > housing.outer) return;
  const Vector3d start = on.at(sense > 0 ? piece.low : piece.high), end = on.at(far);
  const double margin = housing.outer + kPlay * on.module;
  for (const SweptEnvelope& e : m_envelopes) {
    if (e.isOnAxis && e.axisGroup == piece.axisGroup && e.kind == HullKind::shaft) continue;
    if (e.isNear(start, end, margin)) return;
  }
  best = {length, {}, housing, FramePlan::Foot{end.head<2>(), housing.outer + 2 * on.module}, -1};
}

/// Outward at right angles to the axis, then down; or straight down.
void FrameMaker::considerBase(const Piece& piece, Bracket& best) const {
  const AxisLayout& on = axis(piece.axisGroup);
  const double at = (piece.low + piece.high) / 2;
  const Vector3d centre = on.at(at);
  const double floor = m_made.top - 0.5 * m_made.thickness;
  const Vector3d towards =
      std::abs(on.direction.z()) > 1 - 1e-9 ? Vector3d::UnitY() : Vector3d(-Vector3d::UnitZ());
  const Eigen::Isometry3d frame = frameAlong(centre, on.direction, towards);
  const double column = kColumn * module();
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDirections;
    const Vector3d way = frame.linear() * Vector3d(std::cos(angle), std::sin(angle), 0);
    const Vector3d start = centre + (piece.outer - 0.5 * bossWall(on)) * way;
    if (way.z() < -0.999) {
      const double length = centre.z() - floor;
      const Vector3d end(centre.x(), centre.y(), floor);
      const Vector3d below(centre.x(), centre.y(), m_made.top);
      if (length < best.length && isClear(start, below, column, &piece))
        best = {
            length, {{start, end, column}}, {}, FramePlan::Foot{end.head<2>(), column + kRim * module()}, -1};
      continue;
    }
    if (way.z() < -0.5) continue;  // no room for the column
    for (const double reach : reachesFrom(piece, way)) {
      const Vector3d corner = centre + reach * way;
      const double length = reach + corner.z() - floor + 2 * module();  // straight ones rather
      if (length >= best.length) break;
      if (!isClear(start, corner, kBar * module(), &piece)) break;
      const auto slender = bracketTo(piece, way, reach, false);
      if (!slender) continue;
      best = bracketTo(piece, way, reach, true).value_or(*slender);
      best.length = length;
      break;
    }
  }
}

/// A bar outward and a column down to the base, slender or stouter the longer they are; none: no way.
std::optional<Bracket> FrameMaker::bracketTo(const Piece& piece, const Vector3d& way, double reach,
                                             bool isStout) const {
  const AxisLayout& on = axis(piece.axisGroup);
  const Vector3d centre = on.at((piece.low + piece.high) / 2);
  const Vector3d start = centre + (piece.outer - 0.5 * bossWall(on)) * way;
  const double floor = m_made.top - 0.5 * m_made.thickness;
  double bar = kBar * module(), column = kColumn * module();
  if (isStout) {
    column = stout(kColumn, kStoutColumn, (centre + reach * way).z() - floor);
    reach += column - kColumn * module();
    bar = stout(kBar, std::min(kStoutBar, on.width() / 2 / module()), reach);
  }
  const Vector3d corner = centre + reach * way;
  const Vector3d top = corner + Vector3d(0, 0, 1.2 * kColumn * module() + bar - kBar * module());
  const Vector3d end(corner.x(), corner.y(), floor), below(corner.x(), corner.y(), m_made.top);
  if (!isClear(start, corner, bar, &piece) || !isClear(top, below, column, nullptr)) return std::nullopt;
  return Bracket{
      0, {{start, corner, bar}, {top, end, column}}, {}, {{end.head<2>(), column + kRim * module()}}};
}

Bracket FrameMaker::bestBracket(std::size_t group, bool onRims) const {
  Bracket best;
  for (std::size_t p = 0; p < m_pieces.size(); ++p) {
    if (rootOf(p) != rootOf(group)) continue;
    if (onRims) {
      if (m_pieces[p].isBearing) considerRims(m_pieces[p], best);
      continue;
    }
    considerPedestal(m_pieces[p], best);
    considerBase(m_pieces[p], best);
  }
  return best;
}

void FrameMaker::use(std::size_t group, const Bracket& bracket) {
  m_made.bars.insert(m_made.bars.end(), bracket.bars.begin(), bracket.bars.end());
  if (bracket.housing) m_made.housings.push_back(*bracket.housing);
  if (bracket.foot) m_made.feet.push_back(*bracket.foot);
  if (bracket.onto >= 0) join(group, static_cast<std::size_t>(bracket.onto));
}

void FrameMaker::standOnBase(const std::vector<std::size_t>& open) {
  m_made.thickness = kBaseThickness * module();
  m_made.top = baseTop();
  for (const std::size_t group : open) {
    const Bracket bracket = bestBracket(group, false);
    if (!bracket.foot) {
      for (const Piece& piece : m_pieces) {
        const bool isOfGroup = rootOf(static_cast<std::size_t>(&piece - m_pieces.data())) == group;
        if (isOfGroup && piece.isBearing)
          m_made.onPedestals.emplace_back(piece.axisGroup, (piece.low + piece.high) / 2);
      }
      continue;
    }
    use(group, bracket);
  }
}

}  // namespace

FramePlan planFrame(const Arrangement& plan, const GearTrain& train, const Placement& placement) {
  if (plan.axes.empty() || plan.isSimple) return {};
  std::vector<SweptEnvelope> envelopes = sweptEnvelopes(plan, train, placement);
  const auto cases = carrierCases(plan, train, placement);
  FramePlan frame = FrameMaker(plan, train, envelopes).make();
  if (cases.empty()) return frame;
  for (const CasePlan& made : cases) envelopes.push_back(envelopeOf(made, plan.axes[made.axisGroup]));
  FramePlan round = FrameMaker(plan, train, std::move(envelopes)).make();
  return round.onPedestals.size() > frame.onPedestals.size() ? frame : round;
}

}  // namespace geargraph
