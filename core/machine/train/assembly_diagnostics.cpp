#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/foundations/base/translation.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/machine/train/train_diagnostics.h"

namespace geargraph {
namespace {

/// Meshes by gear.
using MeshesOf = std::vector<std::vector<std::size_t>>;

int across(const TrainMesh& mesh, GearOrdinal gear) {
  return mesh.tailGear == gear ? mesh.headGear : mesh.tailGear;
}

/// The gears and meshes from one gear to another without the mesh that closes the loop.
struct AssemblyLoop {
  AssemblyLoop(const GearTrain& train, const MeshesOf& of, std::size_t closing) {
    const TrainMesh& mesh = train.meshes[closing];
    std::map<int, std::size_t> from;  // mesh that led to a gear
    std::vector<int> queue{mesh.tailGear};
    for (std::size_t q = 0; q < queue.size() && !from.contains(mesh.headGear); ++q) {
      for (const std::size_t m : of[static_cast<std::size_t>(queue[q])]) {
        const int other = across(train.meshes[m], queue[q]);
        if (m == closing || other == mesh.tailGear || !from.emplace(other, m).second) continue;
        queue.push_back(other);
      }
    }
    meshes.push_back(closing);
    for (GearOrdinal gear = mesh.headGear; gear != mesh.tailGear;) {
      gears.push_back(gear);
      meshes.push_back(from.at(gear));
      gear = across(train.meshes[from.at(gear)], gear);
    }
    gears.push_back(mesh.tailGear);
  }

  std::vector<int> gears;           ///< from the head of the closing mesh to its tail
  std::vector<std::size_t> meshes;  ///< the closing one, then those between the gears in order
};

/// Two gears on one axis with two planets between them, the loop of an epicyclic train.
struct Epicyclic {
  int planet = -1;    ///< the planet of the closing mesh
  int centralA = -1;  ///< the gear on the common axis that closes
  int centralB = -1;
  bool found = false;

  Epicyclic(const GearTrain& train, const AssemblyLoop& loop) {
    if (loop.gears.size() != 4) return;
    for (std::size_t i = 0; i < 2; ++i) {
      const int a = loop.gears[i];
      const int b = loop.gears[i + 2];
      if (gear(train, a).axisGroup != gear(train, b).axisGroup) continue;
      centralA = a;
      centralB = b;
      planet = loop.gears[i == 0 ? 3 : 0];  // gears[0] and gears[3] are those of the closing mesh
      found = true;
    }
  }
  static const TrainGear& gear(const GearTrain& train, int g) {
    return train.gears[static_cast<std::size_t>(g)];
  }
};

PhaseWheel phaseWheel(const TrainGear& gear) {
  return phaseWheelOf(gear.spec, gear.pose.translation(), gear.pose.linear().col(2),
                      gear.pose.linear().col(0));
}

/// Pitches by which a planet's residual grows when its place is turned about the central axis, per turn: the
/// sum (or difference) of the central tooth counts. Both meshes of the planet are followed by the one
/// equation.
double pitchesPerTurn(const GearTrain& train, const Epicyclic& set) {
  const PhaseWheel a = phaseWheel(Epicyclic::gear(train, set.centralA));
  const PhaseWheel b = phaseWheel(Epicyclic::gear(train, set.centralB));
  const PhaseWheel planet = phaseWheel(Epicyclic::gear(train, set.planet));
  const auto pitchPoint = [&](int central) {
    for (const TrainMesh& m : train.meshes) {
      const bool forth = m.tailGear == central && m.headGear == set.planet;
      const bool back = m.headGear == central && m.tailGear == set.planet;
      if (forth || back) return m.pitchPoint;
    }
    return Eigen::Vector3d(Eigen::Vector3d::Zero());
  };
  const MeshPhase first = meshPhase(a, planet, pitchPoint(set.centralA));
  const MeshPhase second = meshPhase(b, planet, pitchPoint(set.centralB));
  // Turning carrier and planet by beta is turning both central gears by -beta under a planet that stays.
  const double axes = a.axis.dot(b.axis) < 0 ? -1 : 1;
  return std::abs(a.teeth * first.sign - axes * b.teeth * second.sign);
}

/// Planets that mesh with a central gear.
int planetsOf(const GearTrain& train, int central) {
  std::set<int> planets;
  for (const TrainMesh& m : train.meshes) {
    if (m.tailGear == central || m.headGear == central) planets.insert(across(m, central));
  }
  return static_cast<int>(planets.size());
}

/// What the tooth counts of a ring and a sun allow: the nearest that hold `n` planets at equal distances, and
/// the nearest other number of planets.
std::string countAdvice(const TrainGear& sun, const TrainGear& ring, const TrainGear& planet, int n) {
  if (n < 2) return {};
  std::string text;
  for (int step = 1; step <= 2 * n; ++step) {
    const int change = (step % 2 == 1 ? 1 : -1) * ((step + 1) / 2) * 2;  // +2, -2, +4: the ring stays coaxial
    const int teeth = ring.spec.teeth + change;
    if (teeth <= sun.spec.teeth || (sun.spec.teeth + teeth) % n != 0) continue;
    text =
        translated(", or give the ring %1 teeth and the planets %2 (then %3 at equal distances fit)",
                   {std::to_string(teeth), std::to_string((teeth - sun.spec.teeth) / 2), std::to_string(n)});
    break;
  }
  const double orbit = (planet.pose.translation() - sun.pose.translation())
                           .cross(Eigen::Vector3d(sun.pose.linear().col(2)))
                           .norm();
  const int other =
      nearestPlanetCount(n, sun.spec.teeth + ring.spec.teeth, orbit, nominalTipRadius(planet.spec));
  if (other > 0) text += translated(", or use %1 planets at equal distances", {std::to_string(other)});
  return text;
}

std::string planetAdvice(const Mechanism& mechanism, const GearTrain& train, const Epicyclic& set,
                         double residual) {
  const double perTurn = pitchesPerTurn(train, set);
  if (perTurn == 0) return {};
  const TrainGear& planet = Epicyclic::gear(train, set.planet);
  const std::string text =
      ' ' + translated("Planets fit at multiples of 360/%1 = %2 degrees: move that of link %3 by %4 degrees",
                       {fixedText(perTurn, 0), fixedText(360 / perTurn, 3),
                        std::to_string(mechanism.linkLabel(planet.link)),
                        fixedText(std::abs(residual) * 360 / perTurn, 3)});
  int sun = set.centralA;
  int ring = set.centralB;
  if (isRing(Epicyclic::gear(train, sun).spec)) std::swap(sun, ring);
  const TrainGear& inner = Epicyclic::gear(train, sun);
  const TrainGear& outer = Epicyclic::gear(train, ring);
  if (!isDisc(inner.spec) || !isRing(outer.spec)) return text + ".";
  return text + countAdvice(inner, outer, planet, planetsOf(train, sun)) + ".";
}

/// How far a loop's teeth miss each other when one of its gears has another number of them, in the same
/// directions.
double residualWith(const GearTrain& train, const AssemblyLoop& loop, std::size_t changed, int teeth) {
  std::vector<PhaseWheel> wheels;
  for (const int g : loop.gears) wheels.push_back(phaseWheel(Epicyclic::gear(train, g)));
  wheels[changed].teeth = teeth;
  std::vector<PhaseMesh> meshes;
  const int last = static_cast<int>(loop.gears.size()) - 1;
  for (int i = 0; i < last; ++i) {
    meshes.push_back({i, i + 1, train.meshes[loop.meshes[static_cast<std::size_t>(i) + 1]].pitchPoint});
  }
  meshes.push_back({last, 0, train.meshes[loop.meshes.front()].pitchPoint});
  double worst = 0;
  for (const double residual : solvePhases(wheels, meshes).residuals)
    worst = std::max(worst, std::abs(residual));
  return worst;
}

/// The nearest tooth counts with which the loop closes in the same directions, one gear changed at a time.
std::string toothAdvice(const GearTrain& train, const AssemblyLoop& loop) {
  constexpr int kMaxDistance = 8;
  constexpr int kMaxProposals = 2;
  std::string text;
  int proposals = 0;
  for (int step = 1; step <= 2 * kMaxDistance && proposals < kMaxProposals; ++step) {
    const int change = (step % 2 == 1 ? -1 : 1) * ((step + 1) / 2);
    for (std::size_t i = 0; i < loop.gears.size() && proposals < kMaxProposals; ++i) {
      const TrainGear& gear = Epicyclic::gear(train, loop.gears[i]);
      const int teeth = gear.spec.teeth + change;
      if (teeth < kMinGearTeeth || residualWith(train, loop, i, teeth) > kPhaseFits) continue;
      const std::string was = std::to_string(gear.spec.teeth);
      text += proposals == 0 ? ' ' + translated("It fits with %1 instead of %2 teeth on gear %3",
                                                {std::to_string(teeth), was, gear.name})
                             : translated(", or with %1 instead of %2 teeth on gear %3",
                                          {std::to_string(teeth), was, gear.name});
      ++proposals;
    }
  }
  if (text.empty()) text = ' ' + translated("Change tooth counts of the loop, or move one of its axes");
  return text + ".";
}

}  // namespace

Diagnostics assemblyDiagnostics(const Mechanism& mechanism, const GearTrain& train,
                                const std::stop_token& stop) {
  Diagnostics found;
  MeshesOf of(train.gears.size());
  for (std::size_t m = 0; m < train.meshes.size(); ++m) {
    of[static_cast<std::size_t>(train.meshes[m].tailGear)].push_back(m);
    of[static_cast<std::size_t>(train.meshes[m].headGear)].push_back(m);
  }
  for (std::size_t m = 0; m < train.meshes.size(); ++m) {
    const double residual = train.meshes[m].residual;
    if (std::abs(residual) <= kPhaseFits) continue;
    if (stop.stop_requested()) return found;
    const AssemblyLoop loop(train, of, m);
    Diagnostic d;
    d.code = Code::assembly;
    std::string labels;
    std::vector<std::size_t> meshes = loop.meshes;
    std::sort(meshes.begin(), meshes.end());
    for (const std::size_t other : meshes) {
      const MeshOrdinal mesh = train.meshes[other].mesh;
      labels += (labels.empty() ? "" : ", ") + std::to_string(mechanism.meshLabel(mesh));
      d.elements.emplace_back(mechanism.gearMeshes[mesh].id);
    }
    d.message = translated(
        "The loop of meshes %1 cannot be assembled as drawn: at mesh %2 the teeth miss each other by %3 of a "
        "pitch.",
        {labels, std::to_string(mechanism.meshLabel(train.meshes[m].mesh)), fixedText(residual, 3)});
    const Epicyclic set(train, loop);
    const std::string advice = set.found ? planetAdvice(mechanism, train, set, residual) : std::string();
    d.message += advice.empty() ? toothAdvice(train, loop) : advice;
    found.push_back(std::move(d));
  }
  return found;
}

}  // namespace geargraph
