#include "core/theory/statics/losses.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/mechanism/placement/crossing.h"

namespace geargraph {
namespace {

using Pattern = std::vector<MeshLoss::Driver>;

class LossSolver {
 public:
  LossSolver(const KinematicModel& model, const StaticsSolution& lossless, const RadicalColumns& loads,
             const Motion& motion, std::span<const MeshEfficiency> efficiencies,
             const CoefficientMatrix* stiffness, const std::stop_token& stop, int mostPatternMeshes)
      : m_model(model),
        m_lossless(lossless),
        m_loads(loads),
        m_motion(motion),
        m_efficiencies(efficiencies),
        m_stiffness(stiffness),
        m_stop(stop),
        m_mostPatternMeshes(mostPatternMeshes),
        m_powers(powersOf(model, lossless, motion)) {}

  std::optional<LossySolution> run() {
    if (!decides(m_lossless)) return LossySolution{};
    Pattern pattern = patternOf(m_powers);
    std::set<Pattern> tried;
    while (tried.insert(pattern).second) {
      const auto next = attempt(pattern);
      if (m_stop.stop_requested()) return std::nullopt;
      if (m_result.outcome == LossySolution::Outcome::solved) return std::move(m_result);
      if (!next || *next == pattern) break;  // no solution, or one that does not count
      pattern = *next;
    }
    return allPatterns();
  }

 private:
  [[nodiscard]] bool canLose(std::size_t mesh) const {
    return m_powers.rolls[mesh] != 0 && m_efficiencies[mesh].loses();
  }

  /// Is the load of every mesh that can lose power known?
  [[nodiscard]] bool decides(const StaticsSolution& solution) const {
    for (std::size_t mesh = 0; mesh < m_efficiencies.size(); ++mesh)
      if (canLose(mesh) && !solution.isDetermined(static_cast<int>(mesh))) return false;
    return true;
  }

  /// Which gear drives, by mesh; none where it makes no difference.
  [[nodiscard]] Pattern patternOf(const MeshPowers& powers) const {
    Pattern pattern(powers.mesh.size(), MeshLoss::Driver::none);
    for (std::size_t mesh = 0; mesh < pattern.size(); ++mesh) {
      if (!canLose(mesh)) continue;
      const int sign = powers.mesh[mesh].sign();
      if (sign != 0) pattern[mesh] = sign > 0 ? MeshLoss::Driver::tail : MeshLoss::Driver::head;
    }
    return pattern;
  }

  /// The pattern that the solution with this one has; none where it has no solution. Keeps the solution in
  /// m_result where it counts.
  std::optional<Pattern> attempt(const Pattern& pattern) {
    std::vector<MeshLoss> losses(pattern.size());
    for (std::size_t mesh = 0; mesh < pattern.size(); ++mesh)
      losses[mesh] = {pattern[mesh], m_efficiencies[mesh].of(pattern[mesh])};
    const bool isStuck = std::any_of(losses.begin(), losses.end(), [](const MeshLoss& loss) {
      return loss.driver != MeshLoss::Driver::none && loss.efficiency.sign() <= 0;
    });
    if (isStuck) return std::nullopt;
    auto solution = solveStatics(m_model, m_lossless.held, m_loads, losses, m_stop);
    if (!solution || !solution->isBalanced()) return std::nullopt;
    if (m_stiffness != nullptr && !shareByStiffness(m_model, *m_stiffness, *solution, m_stop))
      return std::nullopt;
    if (!decides(*solution)) return std::nullopt;
    const bool isExact = std::all_of(m_efficiencies.begin(), m_efficiencies.end(),
                                     [](const MeshEfficiency& each) { return each.isExact; });
    for (Real& value : solution->values)
      if (!isExact && !value.isZero()) value = Real::inexact(value.number());
    MeshPowers powers = powersOf(m_model, *solution, m_motion);
    const Pattern own = patternOf(powers);
    if (own == pattern && keepsDirections(powers)) {
      m_result.outcome = LossySolution::Outcome::solved;
      m_result.losses = std::move(losses);
      m_result.statics = std::move(*solution);
      m_result.powers = std::move(powers);
    }
    return own;
  }

  /// Does every balance still feed what it fed, and take what it took?
  [[nodiscard]] bool keepsDirections(const MeshPowers& powers) const {
    for (std::size_t part = 0; part < powers.held.size(); ++part) {
      if (m_lossless.held[part].balance < 0) continue;
      const int before = m_powers.held[part].sign();
      if (before != 0 && powers.held[part].sign() != before) return false;
    }
    return true;
  }

  std::optional<LossySolution> allPatterns() {
    std::vector<std::size_t> open;
    for (std::size_t mesh = 0; mesh < m_efficiencies.size(); ++mesh)
      if (canLose(mesh)) open.push_back(mesh);
    m_result.outcome = LossySolution::Outcome::patternLimit;
    const bool canTryAll = static_cast<int>(open.size()) <= m_mostPatternMeshes;
    if (!canTryAll || m_mostPatternMeshes == 0) return std::move(m_result);
    m_result.outcome = LossySolution::Outcome::selfLocking;
    Pattern pattern(m_efficiencies.size(), MeshLoss::Driver::none);
    for (std::size_t number = 0; number < std::size_t{1} << open.size(); ++number) {
      for (std::size_t bit = 0; bit < open.size(); ++bit)
        pattern[open[bit]] = (number >> bit & 1U) != 0 ? MeshLoss::Driver::head : MeshLoss::Driver::tail;
      (void)attempt(pattern);
      if (m_stop.stop_requested()) return std::nullopt;
      if (m_result.outcome == LossySolution::Outcome::solved) break;
    }
    return std::move(m_result);
  }

  const KinematicModel& m_model;
  const StaticsSolution& m_lossless;
  const RadicalColumns& m_loads;
  const Motion& m_motion;
  std::span<const MeshEfficiency> m_efficiencies;
  const CoefficientMatrix* m_stiffness;
  std::stop_token m_stop;
  int m_mostPatternMeshes;
  MeshPowers m_powers;
  LossySolution m_result;
};

/// tan(beta) of both gears of a pair on skew axes, counted so that their sum is above 0.
struct HelixTangents {
  Rational tail;
  Rational head;
  bool isExact = true;
};

HelixTangents helixTangents(const Mechanism& mechanism, const Placement& placement, MeshOrdinal mesh) {
  const MeshGeometry& geometry = *placement.meshes[mesh];
  const GearMesh& element = mechanism.gearMeshes[mesh];
  const ExactLine tail = exactLineOfClass(mechanism, placement, geometry.tailClass);
  const ExactLine head = exactLineOfClass(mechanism, placement, geometry.headClass);
  if (const auto lead = exactLeadTangent(element, tail.point, tail.direction, head.point, head.direction)) {
    const bool isTailWorm = element.tailTeeth < element.headTeeth;
    return {isTailWorm ? lead->inverse() : *lead, isTailWorm ? *lead : lead->inverse(), true};
  }
  const double tailTangent = std::tan(geometry.tailHelix), headTangent = std::tan(geometry.headHelix);
  const double sign = tailTangent + headTangent < 0 ? -1 : 1;
  return {Rational::fromDouble(sign * tailTangent), Rational::fromDouble(sign * headTangent), false};
}

/// mu' of a stated efficiency.
Rational frictionOf(const HelixTangents& tangents, const Rational& stated) {
  const bool tailIsSteeper = tangents.head < tangents.tail;
  const Rational& steep = tailIsSteeper ? tangents.tail : tangents.head;
  const Rational& flat = tailIsSteeper ? tangents.head : tangents.tail;
  return (Rational(1) - stated) / (flat + stated * steep);
}

/// Both efficiencies of a pair that slides along its teeth.
void slide(const HelixTangents& tangents, const Rational& friction, MeshEfficiency& efficiency) {
  const auto passed = [&](const Rational& driver, const Rational& driven) {
    return (Rational(1) - friction * driven) / (Rational(1) + friction * driver);
  };
  efficiency.value = passed(tangents.tail, tangents.head);
  efficiency.backward = passed(tangents.head, tangents.tail);
  efficiency.isExact = efficiency.isExact && tangents.isExact;
}

}  // namespace

bool hasFriction(const Mechanism& mechanism) {
  return (mechanism.gearDefaults && mechanism.gearDefaults->friction) ||
         std::any_of(mechanism.gearMeshes.begin(), mechanism.gearMeshes.end(),
                     [](const GearMesh& mesh) { return mesh.friction.has_value(); });
}

std::vector<MeshEfficiency> efficienciesOf(const Mechanism& mechanism, const Placement& placement,
                                           std::span<const std::optional<MeshContact>> contacts,
                                           const std::optional<Rational>& otherwise) {
  std::vector<MeshEfficiency> efficiencies;
  const std::optional<GearDefaults>& defaults = mechanism.gearDefaults;
  for (std::size_t i = 0; i < mechanism.gearMeshes.size(); ++i) {
    const GearMesh& mesh = mechanism.gearMeshes[i];
    MeshEfficiency& efficiency = efficiencies.emplace_back();
    const bool own = mesh.efficiency || mesh.friction;
    const bool byDefault = !own && defaults && (defaults->efficiency || defaults->friction);
    const auto& stated = own || !byDefault ? mesh.efficiency : defaults->efficiency;
    efficiency.isGiven = own || byDefault || otherwise.has_value();
    const auto& friction = own || !byDefault ? mesh.friction : defaults->friction;
    const auto& geometry = placement.meshes[i];
    if (geometry && hasSkewAxes(geometry->kind)) {
      const HelixTangents tangents = helixTangents(mechanism, placement, static_cast<int>(i));
      if (stated) {
        slide(tangents, frictionOf(tangents, stated->exact()), efficiency);
      } else if (friction && contacts[i]) {
        efficiency.isExact = false;
        slide(tangents, Rational::fromDouble(friction->value() / std::cos(contacts[i]->pressureAngle)),
              efficiency);
      } else if (!own && !byDefault && otherwise) {
        slide(tangents, frictionOf(tangents, *otherwise), efficiency);
      }
    } else if (stated) {
      efficiency.value = stated->exact();
    } else if (friction) {
      if (!contacts[i] || friction->isZero()) continue;
      constexpr double kLeast = 1e-3;  // teeth that slide more than they pass
      const double lost = friction->value() * toothLossFactor(*contacts[i]);
      efficiency.value = Rational::fromDouble(std::max(1 - lost, kLeast));
      efficiency.isExact = false;
    } else if (!own && !byDefault && otherwise) {
      efficiency.value = *otherwise;
    }
  }
  return efficiencies;
}

PortTorques portTorques(const KinematicModel& model, const StaticsSolution& solution,
                        std::span<const MeshLoss> losses, MeshOrdinal mesh) {
  const auto at = static_cast<std::size_t>(mesh);
  const KinematicModel::MeshRow& row = model.meshRow(mesh);
  PortTorques torques{Real(-row.tailTeeth) * solution.values[at],
                      Real(row.sign * row.headTeeth) * solution.values[at]};
  if (losses.empty()) return torques;
  const Real efficiency = losses[at].efficiency;
  if (losses[at].driver == MeshLoss::Driver::tail) torques.head = torques.head * efficiency;
  if (losses[at].driver == MeshLoss::Driver::head) torques.tail = torques.tail * efficiency;
  return torques;
}

int orientationSignAt(const Placement& placement, LinkOrdinal gear, AxisGroupOrdinal axisGroup) {
  const int own = placement.tree->joint[gear];
  if (own >= 0 && placement.classes->classOf[own] == axisGroup)
    return placement.classes->orientationSign[own];
  return 1;  // the gear is the class's link nearest the ground
}

MeshPowers powersOf(const KinematicModel& model, const StaticsSolution& solution, const Motion& motion) {
  const ByLink<Rational> phi = phiOf<Rational>(model, motion);
  const auto at = [&](LinkOrdinal link) -> const Rational& { return phi[link]; };
  MeshPowers powers;
  for (MeshOrdinal mesh = 0; mesh < model.c(); ++mesh) {
    const KinematicModel::MeshRow& row = model.meshRow(mesh);
    const Rational rolling = Rational(row.tailTeeth) * (at(row.links[0]) - at(row.links[1]));
    powers.rolls.push_back(rolling.isZero() ? 0 : 1);
    powers.mesh.push_back(solution.values[static_cast<std::size_t>(mesh)] * Real(rolling));
  }
  for (std::size_t part = 0; part < solution.held.size(); ++part) {
    Rational speed = 0;
    for (const auto& [link, factor] : solution.held[part].byLink) speed += factor * at(link);
    powers.held.push_back(solution.values[static_cast<std::size_t>(model.c()) + part] * Real(speed));
  }
  return powers;
}

Real powerOf(const KinematicModel& model, const RadicalColumns& loads, const Motion& motion) {
  const ByLink<Rational> phi = phiOf<Rational>(model, motion);
  std::vector<Rational> parts;
  for (const RadicalColumns::Column& column : loads.columns()) {
    Rational& part = parts.emplace_back(0);
    for (const auto& [link, force] : column.entries) part += force * phi[link];
  }
  return loads.sumOf(parts);
}

std::optional<LossySolution> solveWithLosses(const KinematicModel& model, const StaticsSolution& lossless,
                                             const RadicalColumns& loads, const Motion& motion,
                                             std::span<const MeshEfficiency> efficiencies,
                                             const CoefficientMatrix* stiffness, const std::stop_token& stop,
                                             int mostPatternMeshes) {
  if (!lossless.isBalanced()) return LossySolution{};
  return LossSolver(model, lossless, loads, motion, efficiencies, stiffness, stop, mostPatternMeshes).run();
}

PowerSums powerSums(const KinematicModel& model, const LossySolution& solution,
                    std::span<const RadicalColumns> loads, const Motion& motion,
                    std::span<const int> heldBy) {
  PowerSums sums;
  const auto add = [&](const Real& power) {
    if (power.sign() > 0) {
      sums.fed += power;
    } else {
      sums.taken -= power;
    }
  };
  std::vector<Real> held = solution.powers.held;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const Real power = powerOf(model, loads[i], motion);
    if (i < heldBy.size() && heldBy[i] >= 0) {
      held[static_cast<std::size_t>(heldBy[i])] += power;
    } else {
      add(power);
    }
  }
  for (std::size_t part = 0; part < held.size(); ++part) {
    if (solution.statics.held[part].balance >= 0) add(held[part]);
  }
  for (std::size_t mesh = 0; mesh < solution.losses.size(); ++mesh) {
    const MeshLoss& loss = solution.losses[mesh];
    if (loss.driver == MeshLoss::Driver::none) continue;
    sums.lost += Real(Rational(1) - loss.efficiency) * solution.powers.mesh[mesh].abs();
  }
  return sums;
}

std::optional<double> selfLockingPart(const KinematicModel& model, const StaticsSolution& lossless,
                                      const RadicalColumns& loads, const Motion& motion,
                                      std::span<const MeshEfficiency> efficiencies,
                                      const CoefficientMatrix* stiffness, const std::stop_token& stop) {
  constexpr int kHalvings = 20;
  Rational free = 0;
  Rational locked = 1;
  std::vector<MeshEfficiency> part(efficiencies.begin(), efficiencies.end());
  for (int i = 0; i < kHalvings; ++i) {
    const Rational middle = (free + locked) / 2;
    for (std::size_t mesh = 0; mesh < part.size(); ++mesh) {
      part[mesh].value = Rational(1) - middle * (Rational(1) - efficiencies[mesh].value);
      if (part[mesh].backward)
        part[mesh].backward = Rational(1) - middle * (Rational(1) - *efficiencies[mesh].backward);
    }
    const auto solution = solveWithLosses(model, lossless, loads, motion, part, stiffness, stop);
    if (!solution) return std::nullopt;
    (solution->outcome == LossySolution::Outcome::solved ? free : locked) = middle;
  }
  return ((free + locked) / 2).toDouble();
}

}  // namespace geargraph
