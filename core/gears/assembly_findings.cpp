#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>

#include "core/gears/train_findings.h"

namespace geargraph {
namespace {

using std::numbers::pi;

std::string number(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

/// The gears and meshes from one gear to another without the mesh that closes the loop.
class Loop {
 public:
  Loop(const GearTrain& train, std::size_t closing) : m_train(train) {
    const TrainMesh& mesh = train.meshes[closing];
    std::vector<int> from(train.gears.size(), -1);  // mesh that led here
    std::vector<int> queue{mesh.tailGear};
    std::vector<bool> seen(train.gears.size(), false);
    seen[static_cast<std::size_t>(mesh.tailGear)] = true;
    for (std::size_t q = 0; q < queue.size(); ++q) {
      for (std::size_t m = 0; m < train.meshes.size(); ++m) {
        if (m == closing) continue;
        const int other = across(m, queue[q]);
        if (other < 0 || seen[static_cast<std::size_t>(other)]) continue;
        seen[static_cast<std::size_t>(other)] = true;
        from[static_cast<std::size_t>(other)] = static_cast<int>(m);
        queue.push_back(other);
      }
    }
    meshes.push_back(closing);
    for (int gear = mesh.headGear; gear != mesh.tailGear;) {
      gears.push_back(gear);
      const int m = from[static_cast<std::size_t>(gear)];
      if (m < 0) return;
      meshes.push_back(static_cast<std::size_t>(m));
      gear = across(static_cast<std::size_t>(m), gear);
    }
    gears.push_back(mesh.tailGear);
  }

  std::vector<int> gears;
  std::vector<std::size_t> meshes;

 private:
  [[nodiscard]] int across(std::size_t m, int gear) const {
    const TrainMesh& mesh = m_train.meshes[m];
    return mesh.tailGear == gear ? mesh.headGear : mesh.headGear == gear ? mesh.tailGear : -1;
  }
  const GearTrain& m_train;
};

/// Two gears on one axis with two planets between them, the loop of an epicyclic train.
struct Epicyclic {
  int planet = -1;    ///< the planet of the closing mesh
  int centralA = -1;  ///< the gear on the common axis that closes
  int centralB = -1;
  bool found = false;

  Epicyclic(const GearTrain& train, const Loop& loop) {
    if (loop.gears.size() != 4) return;
    for (std::size_t i = 0; i < 2; ++i) {
      const int a = loop.gears[i];
      const int b = loop.gears[i + 2];
      if (gear(train, a).axisClass != gear(train, b).axisClass) continue;
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
  return {gear.pose.translation(), gear.pose.linear().col(2), gear.pose.linear().col(0), gear.spec.teeth};
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

std::string planetAdvice(const Mechanism& mechanism, const GearTrain& train, const Epicyclic& set,
                         double residual) {
  const double perTurn = pitchesPerTurn(train, set);
  if (perTurn == 0) return {};
  const TrainGear& planet = Epicyclic::gear(train, set.planet);
  std::string text = " Planets fit at multiples of 360/" + number(perTurn, 0) + " = " +
                     number(360 / perTurn, 3) + " degrees: move that of link " +
                     std::to_string(mechanism.linkLabel(planet.link)) + " by " +
                     number(std::abs(residual) * 360 / perTurn, 3) + " degrees";
  const TrainGear* sun = &Epicyclic::gear(train, set.centralA);
  const TrainGear* ring = &Epicyclic::gear(train, set.centralB);
  if (sun->spec.kind == GearKind::internal) std::swap(sun, ring);
  if (sun->spec.kind == GearKind::external && ring->spec.kind == GearKind::internal) {
    std::set<int> planets;
    for (const TrainMesh& m : train.meshes) {
      if (&train.gears[static_cast<std::size_t>(m.tailGear)] == sun) planets.insert(m.headGear);
      if (&train.gears[static_cast<std::size_t>(m.headGear)] == sun) planets.insert(m.tailGear);
    }
    const int n = static_cast<int>(planets.size());
    for (int step = 1; n > 1 && step <= 2 * n; ++step) {
      const int change =
          (step % 2 == 1 ? 1 : -1) * ((step + 1) / 2) * 2;  // +2, -2, +4: the ring stays coaxial
      const int teeth = ring->spec.teeth + change;
      if (teeth <= sun->spec.teeth || (sun->spec.teeth + teeth) % n != 0) continue;
      text += ", or give the ring " + std::to_string(teeth) + " teeth and the planets " +
              std::to_string((teeth - sun->spec.teeth) / 2) + " (then " + std::to_string(n) +
              " at equal distances fit)";
      break;
    }
  }
  return text + ".";
}

}  // namespace

Diagnostics assemblyDiagnostics(const Mechanism& mechanism, const GearTrain& train) {
  Diagnostics found;
  for (std::size_t m = 0; m < train.meshes.size(); ++m) {
    const double residual = train.meshes[m].residual;
    if (std::abs(residual) <= kPhaseFits) continue;
    const Loop loop(train, m);
    Diagnostic d;
    d.code = Code::assembly;
    std::string labels;
    std::vector<std::size_t> meshes = loop.meshes;
    std::sort(meshes.begin(), meshes.end());
    for (const std::size_t other : meshes) {
      const int mesh = train.meshes[other].mesh;
      labels += (labels.empty() ? "" : ", ") + std::to_string(mechanism.meshLabel(mesh));
      d.elements.emplace_back(mechanism.gearMeshes[static_cast<std::size_t>(mesh)].id);
    }
    d.message = "The loop of meshes " + labels + " cannot be assembled as drawn: at mesh " +
                std::to_string(mechanism.meshLabel(train.meshes[m].mesh)) + " the teeth miss each other by " +
                number(residual, 3) + " of a pitch.";
    const Epicyclic set(train, loop);
    d.message += set.found ? planetAdvice(mechanism, train, set, residual)
                           : std::string(" Change a tooth count of the loop, or move one of its axes.");
    found.push_back(std::move(d));
  }
  return found;
}

}  // namespace geargraph
