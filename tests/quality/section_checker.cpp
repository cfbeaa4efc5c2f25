#include "tests/quality/section_checker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace geargraph::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr std::size_t kBins = 720;

Vector3d vertex(const Solid& solid, std::uint32_t i) {
  const Float3& p = solid.positions[i];
  return {p[0], p[1], p[2]};
}

/// Where the edge leaves the plane's or sphere's inside; the ends in a fixed order, so both triangles of the
/// edge find the same point.
template <class Level>
std::optional<Vector3d> crossing(Vector3d a, Vector3d b, const Level& level) {
  if (std::lexicographical_compare(b.data(), b.data() + 3, a.data(), a.data() + 3)) std::swap(a, b);
  const bool inA = level(a) > 0;
  if (inA == (level(b) > 0)) return std::nullopt;
  double low = 0;
  double high = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    ((level(a + middle * (b - a)) > 0) == inA ? low : high) = middle;
  }
  return a + low * (b - a);
}

template <class Level>
std::vector<std::array<Vector3d, 2>> cut(const Solid& solid, const Level& level) {
  std::vector<std::array<Vector3d, 2>> segments;
  for (const Triangle& t : solid.triangles) {
    std::vector<Vector3d> points;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = crossing(vertex(solid, t[k]), vertex(solid, t[(k + 1) % 3]), level);
      if (p) points.push_back(*p);
    }
    if (points.size() == 2) segments.push_back({points[0], points[1]});
  }
  return segments;
}

Vector2d stereographic(const Vector3d& p) {
  const Vector3d d = p.normalized();
  return Vector2d(d.x(), d.y()) / (1 + d.z());
}

}  // namespace

Section::Section(std::vector<Segment> segments, double sphere)
    : m_segments(std::move(segments)), m_bins(kBins), m_sphere(sphere) {
  for (std::size_t s = 0; s < m_segments.size(); ++s) {
    const Segment& segment = m_segments[s];
    const double a = std::atan2(segment.a.y(), segment.a.x());
    const double turn = std::remainder(std::atan2(segment.b.y(), segment.b.x()) - a, 2 * pi);
    const auto steps = static_cast<int>(std::abs(turn) / (2 * pi) * kBins) + 2;
    std::size_t last = kBins;
    for (int i = 0; i <= steps; ++i) {
      const std::size_t bin = binOf(a + turn * i / steps);
      if (bin != last) m_bins[bin].push_back(s);
      last = bin;
    }
  }
}

std::size_t Section::binOf(double angle) const {
  const double turns = angle / (2 * pi);
  return static_cast<std::size_t>((turns - std::floor(turns)) * kBins) % kBins;
}

Section Section::flat(const Solid& solid, double height) {
  std::vector<Segment> segments;
  for (const auto& [a, b] : cut(solid, [height](const Vector3d& p) { return p.z() - height; })) {
    segments.push_back({{a.x(), a.y()}, {b.x(), b.y()}});
  }
  return {std::move(segments), 0};
}

Section Section::spherical(const Solid& solid, double radius) {
  std::vector<Segment> segments;
  for (const auto& [a, b] : cut(solid, [radius](const Vector3d& p) { return p.norm() - radius; })) {
    // Great circles are bent in the picture; in quarters their bow is far below what is measured.
    constexpr int kParts = 4;
    for (int i = 0; i < kParts; ++i) {
      segments.push_back(
          {stereographic(a + (b - a) * i / kParts), stereographic(a + (b - a) * (i + 1) / kParts)});
    }
  }
  return {std::move(segments), radius};
}

double Section::scaleAt(const Vector2d& point) const {
  return m_sphere > 0 ? 2 * m_sphere / (1 + point.squaredNorm()) : 1;
}

Vector2d Section::toSection(const Vector3d& point) const {
  return m_sphere > 0 ? stereographic(point) : Vector2d(point.x(), point.y());
}

Vector3d Section::toSpace(const Vector2d& point) const {
  if (m_sphere == 0) return {point.x(), point.y(), 0};
  const double s = point.squaredNorm();
  return m_sphere * Vector3d(2 * point.x(), 2 * point.y(), 1 - s) / (1 + s);
}

bool Section::contains(const Vector2d& point) const {
  const Vector2d ray = point.normalized();
  const Vector2d across(-ray.y(), ray.x());
  const double reach = point.norm();
  bool inside = false;
  for (const std::size_t s : m_bins[binOf(std::atan2(point.y(), point.x()))]) {
    const Segment& segment = m_segments[s];
    const double a = across.dot(segment.a);
    const double b = across.dot(segment.b);
    if ((a > 0) == (b > 0)) continue;
    const Vector2d hit = segment.a + a / (a - b) * (segment.b - segment.a);
    if (hit.dot(ray) > reach) inside = !inside;
  }
  return inside;
}

double Section::distance(const Vector2d& point) const {
  const std::size_t middle = binOf(std::atan2(point.y(), point.x()));
  double best = 1e300;
  for (std::size_t k = kBins - 6; k <= kBins + 6; ++k) {
    for (const std::size_t s : m_bins[(middle + k) % kBins]) {
      const Segment& segment = m_segments[s];
      const Vector2d d = segment.b - segment.a;
      const double part =
          std::clamp((point - segment.a).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
      best = std::min(best, (segment.a + part * d - point).squaredNorm());
    }
  }
  return std::sqrt(best) * scaleAt(point);
}

std::vector<Vector2d> Section::samplesNear(const Vector2d& point, double reach) const {
  std::vector<Vector2d> samples;
  const double scaled = reach / scaleAt(point);
  for (const Segment& segment : m_segments) {
    if ((segment.a - point).norm() > scaled) continue;
    samples.push_back(segment.a);
    samples.push_back(0.5 * (segment.a + segment.b));
  }
  return samples;
}

double Section::area() const {
  // Segments are not oriented; each triangle to the axis counts by the side its outer neighbourhood is on.
  double sum = 0;
  for (const Segment& segment : m_segments) {
    const double twofold = segment.a.x() * segment.b.y() - segment.a.y() * segment.b.x();
    const Vector2d middle = 0.5 * (segment.a + segment.b);
    const Vector2d inward = middle - 1e-5 * middle.normalized();
    sum += (contains(inward) ? 1 : -1) * std::abs(twofold) / 2;
  }
  return sum;
}

double interpenetration(const Placed& a, const Placed& b, const Vector3d& pitchPoint, double reach) {
  double deepest = 0;
  const auto probe = [&](const Placed& from, const Placed& into) {
    const Eigen::Isometry3d step = into.pose.inverse() * from.pose;
    const Vector2d near = from.section->toSection(from.pose.inverse() * pitchPoint);
    for (const Vector2d& sample : from.section->samplesNear(near, reach)) {
      const Vector2d there = into.section->toSection(step * from.section->toSpace(sample));
      if (into.section->contains(there)) deepest = std::max(deepest, into.section->distance(there));
    }
  };
  probe(a, b);
  probe(b, a);
  return deepest;
}

MeshReport checkMesh(Placed a, Placed b, int teethA, int teethB, const Vector3d& pitchPoint, double module,
                     int frames, double ratioSign) {
  const auto about = [](const Eigen::Isometry3d& pose, double angle) {
    return pose * Eigen::AngleAxisd(angle, Vector3d::UnitZ());
  };
  const auto velocity = [&](const Placed& g) {
    return Vector3d(g.pose.linear().col(2).cross(pitchPoint - g.pose.translation()));
  };
  const Vector3d va = velocity(a);
  const Vector3d vb = velocity(b);
  const double ratio = ratioSign * va.dot(vb) / vb.squaredNorm();  // the surfaces roll on each other
  const double radius = vb.norm();
  const double pitch = 2 * pi / teethB;
  const double reach = 3.2 * module;
  MeshReport report;
  std::array<double, 2> least{1e300, 1e300};
  std::array<double, 2> most{-1e300, -1e300};
  for (int frame = 0; frame < frames; ++frame) {
    const double turn = 2 * pi / teethA * frame / frames;
    const Placed turnedA{a.section, about(a.pose, turn)};
    const Eigen::Isometry3d rolled = about(b.pose, ratio * turn);
    const auto depth = [&](double more) {
      return interpenetration(turnedA, {b.section, about(rolled, more)}, pitchPoint, reach);
    };
    report.interpenetration = std::max(report.interpenetration, depth(0));
    std::array<double, 2> play{};
    for (const int side : {0, 1}) {
      double low = 0;
      double high = 0.3 * pitch;
      for (int i = 0; i < 22; ++i) {
        const double middle = 0.5 * (low + high);
        (depth(side == 0 ? middle : -middle) > 1e-7 * module ? high : low) = middle;
      }
      play[static_cast<std::size_t>(side)] = side == 0 ? low : -low;
      least[side] = std::min(least[side], play[side]);
      most[side] = std::max(most[side], play[side]);
    }
    const double backlash = (play[0] - play[1]) * radius;
    report.leastBacklash = std::min(report.leastBacklash, backlash);
    report.mostBacklash = std::max(report.mostBacklash, backlash);
    report.phaseError = std::max(report.phaseError, std::abs(play[0] + play[1]) / 2 / pitch);
  }
  report.transmissionError = std::max(most[0] - least[0], most[1] - least[1]) * radius;
  return report;
}

}  // namespace geargraph::test
