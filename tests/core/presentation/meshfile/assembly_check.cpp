#include "tests/core/presentation/meshfile/assembly_check.h"

#include <Eigen/Geometry>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <vector>

namespace geargraph::test {
namespace {

using Eigen::Vector3d;
using Corners = std::array<Vector3d, 3>;
constexpr double kPi = std::numbers::pi;

struct Gear {
  QString name;
  QString type;
  int teeth = 0;
  double module = 0;
  double cone = 0;
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  std::vector<Corners> facets;
};

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

std::vector<Corners> facetsOf(const QByteArray& stl) {
  std::vector<Corners> facets;
  for (qsizetype at = 84; at + 50 <= stl.size(); at += 50) {
    std::array<float, 12> numbers{};
    std::memcpy(numbers.data(), stl.constData() + at, sizeof numbers);
    Corners& facet = facets.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      facet[k] = {numbers[3 * k + 3], numbers[3 * k + 4], numbers[3 * k + 5]};
  }
  return facets;
}

bool isClosed(const std::vector<Corners>& facets) {
  using Point = std::array<double, 3>;
  std::map<std::pair<Point, Point>, int> edges;
  double volume = 0;
  for (const Corners& f : facets) {
    volume += f[0].dot(f[1].cross(f[2])) / 6;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d& a = f[k];
      const Vector3d& b = f[(k + 1) % 3];
      ++edges[{{a.x(), a.y(), a.z()}, {b.x(), b.y(), b.z()}}];
    }
  }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end()) return false;
  }
  return volume > 0;
}

Eigen::Isometry3d poseOf(const QJsonValue& value) {
  Eigen::Isometry3d pose;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      pose.matrix()(row, column) = value.toArray()[row].toArray()[column].toDouble();
    }
  }
  return pose;
}

/// Where two gears roll on each other: a point of it, its direction, and the common normal of the teeth
/// there.
struct PitchLine {
  Vector3d point;
  Vector3d direction;
};

PitchLine pitchLine(const Gear& a, const Eigen::Isometry3d& A, const Gear& b, const Eigen::Isometry3d& B) {
  const Vector3d ka = A.linear().col(2);
  const Vector3d kb = B.linear().col(2);
  if (a.type == "bevel") {
    const double radius = a.module * a.teeth / 2 / std::sin(a.cone);
    const Vector3d across = (kb - kb.dot(ka) * ka).normalized();
    const Vector3d direction = std::cos(a.cone) * ka + std::sin(a.cone) * across;
    return {A.translation() + 0.9 * radius * direction, direction};
  }
  const Vector3d between = B.translation() - A.translation();
  const Vector3d across = between - between.dot(ka) * ka;
  // Internal: the point lies beyond the smaller gear, seen from the ring.
  const double za = a.type == "internal" ? -a.teeth : a.teeth;
  const double zb = b.type == "internal" ? -b.teeth : b.teeth;
  return {A.translation() + za / (za + zb) * across, ka};
}

/// Pitches of a's teeth that lie between the middle of its tooth 0 and the pitch point, counted as the teeth
/// pass.
double position(const Gear& gear, const Eigen::Isometry3d& pose, const PitchLine& line,
                const Vector3d& normal) {
  const Vector3d k = pose.linear().col(2);
  const Vector3d arm = line.point - pose.translation();
  const Vector3d u = (arm - arm.dot(k) * k).normalized();
  const Vector3d e = pose.linear().col(0);
  const double angle = std::atan2(e.cross(u).dot(k), e.dot(u));
  const double sense = k.cross(u).dot(normal) > 0 ? 1 : -1;
  return -sense * gear.teeth * angle / (2 * kPi);
}

/// 0 where a tooth of one gear stands in the middle of a space of the other, at the pitch point; in pitches.
double phaseError(double a, double b) {
  const double missing = a - b - 0.5;
  return std::abs(missing - std::round(missing));
}

double distanceToLine(const Vector3d& p, const PitchLine& line) {
  return (p - line.point).cross(line.direction).norm();
}

/// Points of a's walls near the pitch line, in b's frame: middles of edges and of facets.
std::vector<Vector3d> samples(const Gear& a, const Eigen::Isometry3d& toB, const PitchLine& line,
                              const Vector3d& axis, double reach) {
  std::vector<Vector3d> points;
  for (const Corners& facet : a.facets) {
    const Corners f{toB * facet[0], toB * facet[1], toB * facet[2]};
    const Vector3d normal = (f[1] - f[0]).cross(f[2] - f[0]).normalized();
    if (std::abs(normal.dot(axis)) > 0.95) continue;  // a face
    const Vector3d middle = (f[0] + f[1] + f[2]) / 3;
    if (distanceToLine(middle, line) > reach) continue;
    points.push_back(middle);
    for (std::size_t k = 0; k < 3; ++k) points.push_back((f[k] + f[(k + 1) % 3]) / 2);
  }
  return points;
}

Vector3d nearestOnSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d d = b - a;
  return a + std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) * d;
}

struct Facet {
  Corners corners;
  Vector3d normal;
};

Vector3d nearestOn(const Vector3d& p, const Facet& f) {
  const Vector3d foot = p - (p - f.corners[0]).dot(f.normal) * f.normal;
  bool isInside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d& a = f.corners[k];
    isInside = isInside && (f.corners[(k + 1) % 3] - a).cross(foot - a).dot(f.normal) >= 0;
  }
  if (isInside) return foot;
  Vector3d best = nearestOnSegment(p, f.corners[0], f.corners[1]);
  for (std::size_t k = 1; k < 3; ++k) {
    const Vector3d other = nearestOnSegment(p, f.corners[k], f.corners[(k + 1) % 3]);
    if ((other - p).squaredNorm() < (best - p).squaredNorm()) best = other;
  }
  return best;
}

/// How deep p lies behind the surface; 0 outside. Of facets equally near, the one seen most squarely tells
/// the side.
double depth(const Vector3d& p, const std::vector<Facet>& facets) {
  double nearest = 1e300;
  double squarely = 0;
  for (const Facet& f : facets) {
    if (std::abs((p - f.corners[0]).dot(f.normal)) > nearest + 1e-9) continue;
    const Vector3d away = p - nearestOn(p, f);
    const double distance = away.norm();
    const double side = away.dot(f.normal);
    const bool isTie = std::abs(distance - nearest) <= 1e-9;
    if (distance < nearest - 1e-9 || (isTie && std::abs(side) > std::abs(squarely))) squarely = side;
    nearest = std::min(nearest, distance);
  }
  return squarely < 0 ? nearest : 0;
}

/// Facets by the tooth they belong to, with those of the neighbours: what a point inside can be nearest to.
class FacetsByTooth {
 public:
  explicit FacetsByTooth(int teeth) : m_teeth(teeth), m_facets(static_cast<std::size_t>(teeth)) {}

  void add(const Facet& facet) {
    const double first = azimuth(facet.corners[0]);
    double low = first;
    double high = first;
    for (std::size_t k = 1; k < 3; ++k) {
      const double other = first + std::remainder(azimuth(facet.corners[k]) - first, m_teeth);
      low = std::min(low, other);
      high = std::max(high, other);
    }
    for (int tooth = int(std::floor(low)) - 1; tooth <= int(std::floor(high)) + 1; ++tooth) {
      m_facets[place(tooth)].push_back(facet);
    }
  }
  [[nodiscard]] const std::vector<Facet>& near(const Vector3d& p) const {
    return m_facets[place(int(std::floor(azimuth(p))))];
  }

 private:
  [[nodiscard]] double azimuth(const Vector3d& p) const {
    return std::atan2(p.y(), p.x()) / (2 * kPi) * m_teeth;
  }
  [[nodiscard]] std::size_t place(int tooth) const {
    return static_cast<std::size_t>(((tooth % m_teeth) + m_teeth) % m_teeth);
  }

  int m_teeth;
  std::vector<std::vector<Facet>> m_facets;
};

double penetration(const Gear& a, const Eigen::Isometry3d& A, const Gear& b, const Eigen::Isometry3d& B) {
  const Eigen::Isometry3d toB = B.inverse() * A;
  // Teeth of a ring and a pinion of nearly its size pass each other closely far beyond the mesh.
  const bool isInternal = a.type != b.type;
  const double reach = (!isInternal ? 2.5 : std::abs(a.teeth - b.teeth) < 12 ? 200 : 5) * a.module;
  const PitchLine world = pitchLine(a, A, b, B);
  const PitchLine line{B.inverse() * world.point, B.linear().transpose() * world.direction};
  FacetsByTooth facets(b.teeth);
  for (const Corners& corners : b.facets) {
    const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    bool isNear = false;
    for (const Vector3d& corner : corners)
      isNear = isNear || distanceToLine(corner, line) < reach + 2 * b.module;
    if (isNear) facets.add({corners, normal});
  }
  double deepest = 0;
  for (const Vector3d& p : samples(a, toB, line, toB.linear().col(2), reach)) {
    deepest = std::max(deepest, depth(p, facets.near(p)));
  }
  return deepest / a.module;
}

}  // namespace

AssemblyMeasurements checkedAssembly(const QString& folder, const QString& turned, double pitches) {
  AssemblyMeasurements found;
  const QJsonObject index = QJsonDocument::fromJson(bytesOf(folder + "/assembly.json")).object();
  std::map<QString, Gear> gears;
  for (const QJsonValue& value : index["gears"].toArray()) {
    const QJsonObject json = value.toObject();
    Gear gear{json["name"].toString(),
              json["type"].toString(),
              json["z"].toInt(),
              json["module"].toDouble(),
              json["delta_deg"].toDouble() * kPi / 180,
              Eigen::Isometry3d::Identity(),
              facetsOf(bytesOf(folder + "/" + json["file"].toString()))};
    if (gear.name == turned) {
      gear.turn.rotate(Eigen::AngleAxisd(2 * kPi * pitches / gear.teeth, Vector3d::UnitZ()));
    }
    if (gear.facets.empty()) found.problem = gear.name + " has no facets";
    found.closed = found.closed && isClosed(gear.facets);
    gears[gear.name] = gear;
  }
  found.gears = static_cast<int>(gears.size());
  const QJsonArray frames = index["frames"].toArray();
  found.frames = static_cast<int>(frames.size());
  for (const QJsonValue& value : index["meshes"].toArray()) {
    ++found.pairs;
    const Gear& a = gears[value.toObject()["a"].toString()];
    const Gear& b = gears[value.toObject()["b"].toString()];
    double least = 1e300;
    double most = -1e300;
    double last = 0;
    for (const QJsonValue& frame : frames) {
      const Eigen::Isometry3d A = poseOf(frame.toObject()[a.name]) * a.turn;
      const Eigen::Isometry3d B = poseOf(frame.toObject()[b.name]) * b.turn;
      const PitchLine line = pitchLine(a, A, b, B);
      const Vector3d k = A.linear().col(2);
      const Vector3d arm = line.point - A.translation();
      const Vector3d normal = k.cross(arm - arm.dot(k) * k).normalized();
      const double pa = position(a, A, line, normal);
      found.phaseError = std::max(found.phaseError, phaseError(pa, position(b, B, line, normal)));
      found.penetration = std::max({found.penetration, penetration(a, A, b, B), penetration(b, B, a, A)});
      const double here = least > 1e299 ? pa : last + std::remainder(pa - last, static_cast<double>(a.teeth));
      least = std::min(least, here);
      most = std::max(most, here);
      last = here;
    }
    found.leastTravel = std::min(found.leastTravel, most - least);
  }
  return found;
}

}  // namespace geargraph::test
