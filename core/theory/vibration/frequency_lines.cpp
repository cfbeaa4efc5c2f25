#include "core/theory/vibration/frequency_lines.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "core/foundations/base/contract.h"
#include "core/mechanism/placement/planet_groups.h"
#include "core/theory/states/relative_speed.h"

namespace geargraph {
namespace {

/// phi of every link, by link; 0 for the ground, which stands for a root link (kinematic_model.h).
ByLink<Rational> phiOf(const Placement& placement, const KinematicModel& model,
                       std::span<const Rational> rates) {
  ByLink<Rational> phi(static_cast<std::size_t>(model.n()) + 1);
  if (rates.empty()) return phi;
  const JointTree& tree = *placement.tree;
  for (const LinkOrdinal link : tree.order) {
    if (link == 0) continue;
    const JointOrdinal joint = tree.joint[link];
    const KinematicModel::JointRate& rate = model.jointRate(joint);
    const Rational& turning = rates[static_cast<std::size_t>(static_cast<int>(joint))];
    phi[rate.child] = phi[rate.parent] + (rate.sign > 0 ? turning : -turning);
  }
  return phi;
}

/// The wheels of a mesh against its carrier.
struct MeshSpeeds {
  Rational tail;
  Rational head;
};

MeshSpeeds meshSpeeds(const KinematicModel::MeshRow& row, const ByLink<Rational>& phi) {
  return {(phi[row.links[0]] - phi[row.links[1]]).abs(), (phi[row.links[2]] - phi[row.links[3]]).abs()};
}

/// How many planets pass a wheel, by mesh and by whether the wheel is the tail.
using Passes = std::map<std::pair<int, bool>, int>;

struct PlanetPass {
  LinkOrdinal gear = 0;
  LinkOrdinal carrier = 0;
  int planets = 1;
  MeshOrdinal mesh = 0;  ///< one of those by which they pass
  bool isTail = false;   ///< of the gear in that mesh
};

class LineMaker {
 public:
  LineMaker(const Mechanism& mechanism, const Placement& placement, const KinematicModel& model,
            const FrequencyMotion& motion, const Rational& reference, const FrequencyOptions& options)
      : m_mechanism(mechanism),
        m_placement(placement),
        m_model(model),
        m_motion(motion),
        m_perReference(reference.inverse()),
        m_options(options),
        m_phi(phiOf(placement, model, motion.rates)),
        m_idle(phiOf(placement, model, motion.idle)) {}

  std::vector<FrequencyLine> make() {
    addShafts();
    addJoints();
    addPlanetPasses();
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh) addMesh(mesh);
    return std::move(m_lines);
  }

 private:
  void add(FrequencyLine line, const Rational& speed) {
    line.ratio = speed.abs() * m_perReference;
    if (!line.ratio.isZero()) m_lines.push_back(std::move(line));
  }

  void addShafts() {
    for (LinkOrdinal link = 1; link <= m_model.n(); ++link) {
      const auto speed = shaftSpeed(m_placement, m_motion, link);
      if (speed) add({.kind = FrequencyKind::shaft, .link = link}, *speed);
    }
  }

  void addJoints() {
    const JointTree& tree = *m_placement.tree;
    for (JointOrdinal joint = 0; joint < m_model.t(); ++joint) {
      const auto place = static_cast<std::size_t>(static_cast<int>(joint));
      const bool isFree = !m_motion.idle.empty() && !m_motion.idle[place].isZero();
      if (isFree || tree.joints[joint].tail == 0 || tree.joints[joint].head == 0) continue;
      add({.kind = FrequencyKind::joint, .joint = joint}, m_motion.rates[place]);
    }
  }

  /// Does the mesh turn in the free motion?
  [[nodiscard]] bool isFree(MeshOrdinal mesh) const {
    return !m_motion.idle.empty() && !meshSpeeds(m_model.meshRow(mesh), m_idle).tail.isZero();
  }

  [[nodiscard]] std::vector<PlanetPass> planetPasses() {
    std::vector<PlanetPass> passes;
    for (const auto& set : planetSets(m_mechanism, m_placement, PlanetScope::all)) {
      const int planets = set.size() == 1 ? m_options.planets : static_cast<int>(set.size());
      for (const PlanetGroup& group : set) {
        for (const MeshOrdinal mesh : group.meshes) {
          const MeshGeometry& geometry = *m_placement.meshes[mesh];
          for (const bool isTail : {true, false}) {
            const LinkOrdinal gear = isTail ? geometry.tail : geometry.head;
            if (std::find(group.links.begin(), group.links.end(), gear) != group.links.end()) continue;
            m_passes[{static_cast<int>(mesh), isTail}] = planets;
            const bool isKnown = std::any_of(passes.begin(), passes.end(), [&](const PlanetPass& known) {
              return known.gear == gear && known.carrier == geometry.carrier && known.planets == planets;
            });
            if (!isKnown) passes.push_back({gear, geometry.carrier, planets, mesh, isTail});
          }
        }
      }
    }
    return passes;
  }

  void addPlanetPasses() {
    for (const PlanetPass& pass : planetPasses()) {
      if (isFree(pass.mesh)) continue;
      const MeshSpeeds speeds = meshSpeeds(m_model.meshRow(pass.mesh), m_phi);
      add({.kind = FrequencyKind::planetPass, .link = pass.gear, .planets = pass.planets},
          Rational(pass.planets) * (pass.isTail ? speeds.tail : speeds.head));
    }
  }

  void addMesh(MeshOrdinal mesh) {
    if (!touches(m_placement.meshes[mesh]->kind)) return;  // no teeth that meet
    const KinematicModel::MeshRow& row = m_model.meshRow(mesh);
    const MeshSpeeds speeds = meshSpeeds(row, m_phi);
    const Rational toothMesh = Rational(row.tailTeeth) * speeds.tail;
    GEARGRAPH_REQUIRE(toothMesh == Rational(row.headTeeth) * speeds.head);
    if (isFree(mesh) || toothMesh.isZero()) return;
    for (int harmonic = 1; harmonic <= m_options.harmonics; ++harmonic) {
      const Rational center = Rational(harmonic) * toothMesh;
      add({.kind = FrequencyKind::toothMesh, .mesh = mesh, .harmonic = harmonic}, center);
      addSidebands(mesh, harmonic, center, speeds);
    }
    const int phases = std::gcd(row.tailTeeth, row.headTeeth);
    add({.kind = FrequencyKind::assemblyPhase, .mesh = mesh}, toothMesh * Rational(1, phases));
    add({.kind = FrequencyKind::huntingTooth, .mesh = mesh},
        toothMesh * Rational(phases, std::int64_t{row.tailTeeth} * row.headTeeth));
  }

  void addSidebands(MeshOrdinal mesh, int harmonic, const Rational& center, const MeshSpeeds& speeds) {
    const MeshGeometry& geometry = *m_placement.meshes[mesh];
    for (const bool isTail : {true, false}) {
      const Rational& turning = isTail ? speeds.tail : speeds.head;
      const LinkOrdinal wheel = isTail ? geometry.tail : geometry.head;
      const auto passes = m_passes.find({static_cast<int>(mesh), isTail});
      // One planet passes as often as its carrier turns against the gear: the line is there already.
      const int planets = passes == m_passes.end() || passes->second == 1 ? 0 : passes->second;
      for (const int each : {0, planets}) {
        for (int k = -m_options.sidebands; k <= m_options.sidebands; ++k) {
          if (k == 0) continue;
          add({.kind = FrequencyKind::sideband,
               .link = wheel,
               .mesh = mesh,
               .harmonic = harmonic,
               .sideband = k,
               .planets = each},
              center + Rational(std::int64_t{k} * std::max(each, 1)) * turning);
        }
        if (planets == 0) break;
      }
    }
  }

  const Mechanism& m_mechanism;
  const Placement& m_placement;
  const KinematicModel& m_model;
  const FrequencyMotion& m_motion;
  Rational m_perReference;
  const FrequencyOptions& m_options;
  ByLink<Rational> m_phi;
  ByLink<Rational> m_idle;
  Passes m_passes;
  std::vector<FrequencyLine> m_lines;
};

}  // namespace

std::string_view frequencyKindName(FrequencyKind kind) {
  constexpr std::array<std::string_view, 7> kNames = {
      "shaft", "joint", "planet-pass", "tooth-mesh", "sideband", "assembly-phase", "hunting-tooth"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::optional<Rational> shaftSpeed(const Placement& placement, const FrequencyMotion& motion,
                                   LinkOrdinal link) {
  if (!motion.idle.empty() && !absoluteSpeed(placement, motion.idle, link).empty()) return std::nullopt;
  const std::vector<SpeedAbout> speeds = absoluteSpeed(placement, motion.rates, link);
  if (speeds.size() > 1) return std::nullopt;
  return speeds.empty() ? Rational(0) : speeds.front().speed.abs();
}

std::vector<FrequencyLine> frequencyLines(const Mechanism& mechanism, const Placement& placement,
                                          const KinematicModel& model, const FrequencyMotion& motion,
                                          const Rational& reference, const FrequencyOptions& options) {
  GEARGRAPH_REQUIRE(reference.sign() > 0);
  return LineMaker(mechanism, placement, model, motion, reference, options).make();
}

}  // namespace geargraph
