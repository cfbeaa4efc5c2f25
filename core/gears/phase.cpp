#include "core/gears/phase.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/base/contract.h"

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

MeshPhase meshPhase(const PhaseWheel& a, const PhaseWheel& b, const Vector3d& pitchPoint) {
  const Vector3d ua = radial(a, pitchPoint);
  const Vector3d ub = radial(b, pitchPoint);
  const Vector3d normal = a.axis.cross(ua);  // sig_a is +1 by this choice
  const int sign = b.axis.cross(ub).dot(normal) >= 0 ? 1 : -1;
  return {angleOf(a, ua), angleOf(b, ub), sign};
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

PhaseSolution solvePhases(std::span<const PhaseWheel> wheels, std::span<const PhaseMesh> meshes) {
  PhaseSolution solution;
  solution.angles.assign(wheels.size(), 0);
  solution.residuals.assign(meshes.size(), 0);
  solution.closing.assign(meshes.size(), false);
  const auto of = meshesOf(wheels.size(), meshes);
  std::vector<bool> placed(wheels.size(), false);
  std::vector<bool> used(meshes.size(), false);
  for (std::size_t first = 0; first < wheels.size(); ++first) {
    if (placed[first]) continue;
    placed[first] = true;
    std::vector<std::size_t> queue{first};
    for (std::size_t q = 0; q < queue.size(); ++q) {
      const std::size_t from = queue[q];
      for (const int m : of[from]) {
        const PhaseMesh& mesh = meshes[static_cast<std::size_t>(m)];
        const auto other = static_cast<std::size_t>(mesh.a == static_cast<int>(from) ? mesh.b : mesh.a);
        if (placed[other]) continue;
        placed[other] = used[static_cast<std::size_t>(m)] = true;
        const MeshPhase phase = meshPhase(wheels[from], wheels[other], mesh.pitchPoint);
        solution.angles[other] = meshingAngle(phase, wheels[from], solution.angles[from], wheels[other]);
        queue.push_back(other);
      }
    }
  }
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    if (used[m]) continue;
    const auto a = static_cast<std::size_t>(meshes[m].a);
    const auto b = static_cast<std::size_t>(meshes[m].b);
    const MeshPhase phase = meshPhase(wheels[a], wheels[b], meshes[m].pitchPoint);
    solution.closing[m] = true;
    solution.residuals[m] = phaseError(phase, wheels[a], solution.angles[a], wheels[b], solution.angles[b]);
  }
  return solution;
}

}  // namespace geargraph
