#include "core/machine/teeth/phase.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/foundations/base/contract.h"
#include "core/machine/teeth/wheel_kind.h"

namespace geargraph {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

Vector3d radial(const PhaseWheel& wheel, const Vector3d& point) {
  const Vector3d arm = point - wheel.centre;
  return (arm - arm.dot(wheel.axis) * wheel.axis).normalized();
}

double angleOf(const PhaseWheel& wheel, const Vector3d& u) {
  return std::atan2(wheel.mark.cross(u).dot(wheel.axis), wheel.mark.dot(u));
}

/// By how much the section through a point is turned against mid face.
double twistAt(const PhaseWheel& wheel, const Vector3d& point) {
  if (wheel.twist == 0) return 0;
  const double height = (point - wheel.centre).dot(wheel.axis);
  return wheel.twist * (wheel.herringbone ? -std::abs(height) : height);
}

/// Into (-1/2, 1/2].
double wrapped(double turns) {
  const double rest = turns - std::round(turns);
  return rest <= -0.5 ? rest + 1 : rest;
}

/// Wheels that each wheel meshes with, as mesh positions.
std::vector<std::vector<int>> meshesOf(std::size_t wheels, std::span<const PhaseMesh> meshes) {
  std::vector<std::vector<int>> of(wheels);
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    of.at(static_cast<std::size_t>(meshes[m].a)).push_back(static_cast<int>(m));
    of.at(static_cast<std::size_t>(meshes[m].b)).push_back(static_cast<int>(m));
  }
  return of;
}

}  // namespace

PhaseWheel phaseWheelOf(const GearSpec& spec, const Vector3d& centre, const Vector3d& axis,
                        const Vector3d& mark) {
  PhaseWheel wheel{centre, axis, mark, spec.teeth};
  // All sections of a bevel are in phase with those of its mate on the same sphere.
  if (spec.helixAngle != 0 && !isConical(spec)) wheel.twist = std::tan(spec.helixAngle) / pitchRadius(spec);
  wheel.herringbone = spec.herringbone;
  return wheel;
}

Vector3d pitchPlaneNormal(const PhaseWheel& wheel, const Vector3d& pitchPoint) {
  const Vector3d arm = pitchPoint - wheel.centre;
  const double height = arm.dot(wheel.axis);
  const Vector3d across = wheel.axis.cross(arm - height * wheel.axis);  // as long as the radius is
  const double twist = wheel.herringbone && height > 0 ? -wheel.twist : wheel.twist;
  return (across.normalized() - twist * across.norm() * wheel.axis).normalized();
}

MeshPhase meshPhase(const PhaseWheel& a, const PhaseWheel& b, const Vector3d& pitchPoint,
                    const Vector3d& toothNormal) {
  const Vector3d ua = radial(a, pitchPoint);
  const Vector3d ub = radial(b, pitchPoint);
  const Vector3d normal = toothNormal.isZero() ? pitchPlaneNormal(a, pitchPoint) : toothNormal;
  const auto passes = [&](const PhaseWheel& wheel, const Vector3d& u) {
    return wheel.axis.cross(u).dot(normal) >= 0 ? 1 : -1;
  };
  const int sign = passes(a, ua) * passes(b, ub);
  return {angleOf(a, ua) - twistAt(a, pitchPoint), angleOf(b, ub) - twistAt(b, pitchPoint), sign};
}

double phaseError(const MeshPhase& phase, const PhaseWheel& a, double angleA, const PhaseWheel& b,
                  double angleB) {
  const double sum = a.teeth * (angleA - phase.psiA) - phase.sign * b.teeth * (angleB - phase.psiB);
  return wrapped((sum - pi) / (2 * pi));
}

double meshingAngle(const MeshPhase& phase, const PhaseWheel& a, double angleA, const PhaseWheel& b) {
  const double pitches = (a.teeth * (angleA - phase.psiA) - pi) / (2 * pi);
  // sign z_b (angle - psi_b) = 2 pi pitches (mod 2 pi)
  const double angle = phase.psiB + phase.sign * 2 * pi * pitches / b.teeth;
  return 2 * pi / b.teeth * wrapped(angle * b.teeth / (2 * pi));
}

namespace {

/// The spanning forest while it grows, and what is left over of the meshes that close loops.
class PhaseSolver {
 public:
  PhaseSolver(std::span<const PhaseWheel> wheels, std::span<const PhaseMesh> meshes)
      : m_wheels(wheels), m_meshes(meshes), m_of(meshesOf(wheels.size(), meshes)), m_way(wheels.size(), 0) {
    m_solution.angles.assign(wheels.size(), 0);
    m_solution.residuals.assign(meshes.size(), 0);
    m_solution.closing.assign(meshes.size(), true);
  }

  PhaseSolution solve() {
    for (std::size_t first = 0; first < m_wheels.size(); ++first) {
      if (m_way[first] != 0) continue;
      const std::vector<std::size_t> tree = grow(first);
      turnToFit(tree);
    }
    for (std::size_t m = 0; m < m_meshes.size(); ++m) {
      if (m_solution.closing[m]) m_solution.residuals[m] = residual(m);
    }
    return std::move(m_solution);
  }

 private:
  [[nodiscard]] static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] double residual(std::size_t m) const;
  std::vector<std::size_t> grow(std::size_t first);
  void turnToFit(const std::vector<std::size_t>& tree);

  std::span<const PhaseWheel> m_wheels;
  std::span<const PhaseMesh> m_meshes;
  std::vector<std::vector<int>> m_of;
  std::vector<int>
      m_way;  ///< +1 or -1: pitches that pass a wheel's points for one of the first; 0: no angle yet
  PhaseSolution m_solution;
};

double PhaseSolver::residual(std::size_t m) const {
  const std::size_t a = at(m_meshes[m].a);
  const std::size_t b = at(m_meshes[m].b);
  const MeshPhase phase =
      meshPhase(m_wheels[a], m_wheels[b], m_meshes[m].pitchPoint, m_meshes[m].toothNormal);
  return phaseError(phase, m_wheels[a], m_solution.angles[a], m_wheels[b], m_solution.angles[b]);
}

/// Gives every wheel that meshes tie to the first its angle; the wheels in that order.
std::vector<std::size_t> PhaseSolver::grow(std::size_t first) {
  m_way[first] = 1;
  std::vector<std::size_t> queue{first};
  for (std::size_t q = 0; q < queue.size(); ++q) {
    const std::size_t from = queue[q];
    for (const int m : m_of[from]) {
      const PhaseMesh& mesh = m_meshes[at(m)];
      const std::size_t other = at(mesh.a) == from ? at(mesh.b) : at(mesh.a);
      if (m_way[other] != 0) continue;
      m_solution.closing[at(m)] = false;
      const MeshPhase phase = meshPhase(m_wheels[from], m_wheels[other], mesh.pitchPoint, mesh.toothNormal);
      m_way[other] = phase.sign * m_way[from];
      m_solution.angles[other] =
          meshingAngle(phase, m_wheels[from], m_solution.angles[from], m_wheels[other]);
      queue.push_back(other);
    }
  }
  return queue;
}

/// Turns a tree as a whole by what the first loop that is locked (an odd ring of external wheels, say) leaves
/// over: turning its wheels moves the teeth of its last mesh by two pitches for one, so that there always is
/// a place where they fit. Loops that can turn do not feel it.
void PhaseSolver::turnToFit(const std::vector<std::size_t>& tree) {
  for (const std::size_t wheel : tree) {
    for (const int m : m_of[wheel]) {
      const PhaseMesh& mesh = m_meshes[at(m)];
      const std::size_t a = at(mesh.a);
      const std::size_t b = at(mesh.b);
      if (!m_solution.closing[at(m)] || a != wheel) continue;
      const MeshPhase phase = meshPhase(m_wheels[a], m_wheels[b], mesh.pitchPoint, mesh.toothNormal);
      if (phase.sign * m_way[b] == m_way[a]) continue;
      const double pitches = -residual(at(m)) / (2 * m_way[a]);
      for (const std::size_t w : tree)
        m_solution.angles[w] += m_way[w] * pitches * 2 * pi / m_wheels[w].teeth;
      return;
    }
  }
}

}  // namespace

PhaseSolution solvePhases(std::span<const PhaseWheel> wheels, std::span<const PhaseMesh> meshes) {
  return PhaseSolver(wheels, meshes).solve();
}

}  // namespace geargraph
