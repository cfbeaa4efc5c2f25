#include "core/design/collision/relative_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/theory/pose/period.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;

constexpr double kParallel = 1e-9;  // sine of the angle

double sineBetween(const TurningLine& a, const TurningLine& b) {
  return a.direction.cross(b.direction).norm();
}

double distanceOf(const TurningLine& line, const Vector3d& point) {
  return (point - line.point).cross(line.direction).norm();
}

Vector3d footOn(const TurningLine& line, const Vector3d& point) {
  return line.point + (point - line.point).dot(line.direction) * line.direction;
}

bool isSameLine(const TurningLine& a, const TurningLine& b, double module) {
  return sineBetween(a, b) < kParallel && distanceOf(a, b.point) < 1e-6 * module;
}

RelativeMotion::Turn turnOf(const JointRates& motion, JointOrdinal joint, int direction) {
  const auto j = static_cast<std::size_t>(joint);
  RelativeMotion::Turn turn{motion.lines[j], direction * motion.rates[j], {}};
  if (!motion.exact.empty()) turn.exact = Rational(direction) * motion.exact[j];
  return turn;
}

bool isAtRest(const RelativeMotion::Turn& turn) {
  return turn.exact ? turn.exact->isZero() : turn.rate == 0;
}

/// Both turns as one about the line of the first.
void add(RelativeMotion::Turn& to, const RelativeMotion::Turn& turn) {
  const double sense = to.line.direction.dot(turn.line.direction) < 0 ? -1 : 1;
  const double most = std::max(std::abs(to.rate), std::abs(turn.rate));
  to.rate += sense * turn.rate;
  if (std::abs(to.rate) < 1e-12 * most) to.rate = 0;
  if (to.exact) *to.exact += Rational(static_cast<int>(sense)) * *turn.exact;
}

/// The greatest speed of Q's points, from the chain of turns that carries it, and the ball about a point of
/// the first line that they never leave.
struct Reach {
  double speed = 0;
  Vector3d centre{0, 0, 0};
  double radius = 0;
};

/// `inner` is nearest to the part, which is `outer`most of a chain that is walked inwards.
template <class Iterator>
Reach reachOf(Iterator inner, Iterator end, const CollisionPart& part) {
  Reach reach;
  reach.centre = footOn(inner->line, part.centre);
  reach.radius = reachFrom(part, reach.centre);
  reach.speed = std::abs(inner->rate) * axialExtent(part, inner->line).outer;
  for (++inner; inner != end; ++inner) {
    reach.speed += std::abs(inner->rate) * (distanceOf(inner->line, reach.centre) + reach.radius);
    const Vector3d foot = footOn(inner->line, reach.centre);
    reach.radius += (foot - reach.centre).norm();
    reach.centre = foot;
  }
  return reach;
}

bool areApart(double lowA, double highA, double lowB, double highB) {
  return highA < lowB || highB < lowA;
}

/// Are the parts on different stretches along the lines, which are all parallel, or on different rings about
/// the first?
bool isClearAlongLines(std::span<const RelativeMotion::Turn> turns, const CollisionPart& p,
                       const CollisionPart& q) {
  const TurningLine& first = turns.front().line;
  const TurningLine& last = turns.back().line;
  const bool parallel = std::all_of(turns.begin(), turns.end(), [&](const RelativeMotion::Turn& turn) {
    return sineBetween(turn.line, first) < kParallel;
  });
  if (!parallel) return false;
  const AxialExtent ofP = axialExtent(p, first);
  const AxialExtent alongFirst = axialExtent(q, first);
  if (areApart(ofP.low, ofP.high, alongFirst.low, alongFirst.high)) return true;
  if (turns.size() == 1) return areApart(ofP.inner, ofP.outer, alongFirst.inner, alongFirst.outer);
  if (turns.size() > 2) return false;
  const AxialExtent ofQ = axialExtent(q, last);
  const double apart = distanceOf(first, last.point);
  const double nearest = std::max({0.0, apart - ofQ.outer, ofQ.inner - apart});
  return areApart(ofP.inner, ofP.outer, nearest, apart + ofQ.outer);
}

/// A box about everything that the points of a box can reach when they turn about a line.
Eigen::AlignedBox3d turnedBox(const Eigen::AlignedBox3d& box, const TurningLine& line) {
  double radius = 0;
  double low = 1e300;
  double high = -1e300;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d p = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
    radius = std::max(radius, distanceOf(line, p));
    const double along = (p - line.point).dot(line.direction);
    low = std::min(low, along);
    high = std::max(high, along);
  }
  Eigen::AlignedBox3d swept;
  const Vector3d out = radius * (Vector3d::Ones() - line.direction.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
  for (const double along : {low, high}) {
    const Vector3d middle = line.point + along * line.direction;
    swept.extend(middle - out);
    swept.extend(middle + out);
  }
  return swept;
}

}  // namespace

RelativeMotion::RelativeMotion(const JointRates& motion, const CollisionPart& p, const CollisionPart& q) {
  const double module = std::min(p.module, q.module);
  for (const PathStep& step : treePath(motion.tree, p.link, q.link)) {
    const Turn turn = turnOf(motion, step.joint, step.direction);
    if (isAtRest(turn)) continue;
    if (m_turns.empty() || !isSameLine(m_turns.back().line, turn.line, module)) {
      m_turns.push_back(turn);
      continue;
    }
    add(m_turns.back(), turn);
    if (isAtRest(m_turns.back())) m_turns.pop_back();
  }
  const auto isAbout = [&](const CollisionPart& part, const Turn& turn) {
    return part.revolvedAbout && isSameLine(*part.revolvedAbout, turn.line, module);
  };
  if (!m_turns.empty() && isAbout(p, m_turns.front())) m_turns.erase(m_turns.begin());
  if (!m_turns.empty() && isAbout(q, m_turns.back())) m_turns.pop_back();
}

Eigen::Isometry3d RelativeMotion::displacement(double time) const {
  Eigen::Isometry3d displacement = Eigen::Isometry3d::Identity();
  for (const Turn& turn : m_turns) {
    const double angle = std::remainder(turn.rate * time, 2 * std::numbers::pi);
    Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
    step.linear() = Eigen::AngleAxisd(angle, turn.line.direction).toRotationMatrix();
    step.translation() = turn.line.point - step.linear() * turn.line.point;
    displacement = displacement * step;
  }
  return displacement;
}

double RelativeMotion::period() const {
  if (m_turns.size() == 1) return 2 * std::numbers::pi / std::abs(m_turns.front().rate);
  std::vector<Rational> rates;
  for (const Turn& turn : m_turns) {
    if (!turn.exact) return 0;
    rates.push_back(*turn.exact);
  }
  const auto turns = commonPeriod(rates);
  return turns ? 2 * std::numbers::pi * turns->toDouble() : 0;
}

double RelativeMotion::fastestRate() const {
  double fastest = 0;
  for (const Turn& turn : m_turns) fastest = std::max(fastest, std::abs(turn.rate));
  return fastest;
}

PairBounds pairBounds(const RelativeMotion& motion, const CollisionPart& p, const CollisionPart& q) {
  const std::vector<RelativeMotion::Turn>& turns = motion.turns();
  const Reach ofQ = reachOf(turns.rbegin(), turns.rend(), q);
  const Reach ofP = reachOf(turns.begin(), turns.end(), p);
  PairBounds bounds;
  bounds.speed = std::min(ofP.speed, ofQ.speed);
  bounds.isClear = (ofQ.centre - p.centre).norm() > ofQ.radius + p.radius ||
                   (ofP.centre - q.centre).norm() > ofP.radius + q.radius || isClearAlongLines(turns, p, q);
  return bounds;
}

Eigen::AlignedBox3d sweptBox(const JointRates& motion, const CollisionPart& part) {
  const Vector3d reach = Vector3d::Constant(part.radius);
  Eigen::AlignedBox3d box(part.centre - reach, part.centre + reach);
  bool isFirst = true;
  for (LinkOrdinal link = part.link; motion.tree.parent(link) >= 0; link = motion.tree.parent(link)) {
    const auto joint = static_cast<std::size_t>(motion.tree.jointToParent(link));
    const TurningLine& line = motion.lines[joint];
    if (motion.rates[joint] == 0) continue;
    const bool isOwn = isFirst && part.revolvedAbout && isSameLine(*part.revolvedAbout, line, part.module);
    if (!isOwn) box = turnedBox(box, line);
    isFirst = isFirst && isOwn;
  }
  return box;
}

}  // namespace geargraph
