#include "core/theory/dynamics/dynamics_report.h"

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/slide_checks.h"
#include "core/theory/pose/turning_lines.h"
#include "core/theory/statics/applied_loads.h"

namespace geargraph {
namespace {

Eigen::Vector3d vectorOf(const ExactVector3& exact) {
  return Eigen::Vector3d(toDoubles(exact).data());
}

/// K, joints x inputs, from the solution of the inputs.
Eigen::MatrixXd gainsOf(const LiveSolution& solution) {
  const auto inputs = static_cast<Eigen::Index>(solution.inputs.size());
  const auto outputs = static_cast<Eigen::Index>(solution.outputs.size());
  Eigen::MatrixXd gains = Eigen::MatrixXd::Zero(inputs + outputs, inputs);
  for (Eigen::Index i = 0; i < inputs; ++i) gains(solution.inputs[static_cast<std::size_t>(i)], i) = 1;
  for (Eigen::Index row = 0; row < outputs; ++row) {
    for (Eigen::Index i = 0; i < inputs; ++i) {
      gains(solution.outputs[static_cast<std::size_t>(row)], i) =
          solution.matrix[static_cast<std::size_t>(row * inputs + i)];
    }
  }
  return gains;
}

/// The link that an axis of the document moves with: the one nearest the ground among those it joins.
int carrierOf(const Placement& placement, AxisOrdinal axis) {
  const std::span<const int> axisOf = placement.tree->axisOf;
  for (std::size_t joint = 0; joint < axisOf.size(); ++joint) {
    if (axisOf[joint] != axis) continue;
    const AxisGroups& classes = *placement.classes;
    return classes.classes[classes.classOf[joint]].rootLink;
  }
  return 0;
}

/// Everything `by` nearer to the origin.
void shift(DynamicTrain& train, const Eigen::Vector3d& by) {
  for (TurningLine& line : train.lines) line.point -= by;
  for (MassProperties& link : train.links) link.center -= by;
  for (MovingLoad& load : train.loads) load.point -= by;
}

}  // namespace

std::vector<MovingLoad> movingLoads(const Mechanism& mechanism, const Placement& placement,
                                    std::span<const Load> loads, double metres) {
  StaticsProblem problem;
  addLoads(mechanism, placement, loads, problem);
  std::vector<MovingLoad> moving;
  for (const AppliedTorque& applied : problem.torques) {
    MovingLoad load;
    const double torque = applied.torque.toDouble();
    if (applied.place.inJoint()) {
      load.joint = applied.place.joint;
      load.torque.x() = torque;
    } else {
      load.link = applied.place.link;
      load.torque = torque * vectorOf(applied.place.direction).normalized();
      load.carrier = carrierOf(placement, applied.place.axis);
    }
    moving.push_back(load);
  }
  for (const AppliedForce& applied : problem.forces) {
    MovingLoad load;
    load.link = applied.link;
    load.force = vectorOf(applied.force);
    load.point = metres * vectorOf(applied.point);
    moving.push_back(load);
  }
  return moving;
}

std::optional<Expected<MechanismDynamics>> dynamicsOf(const Mechanism& mechanism, const KinematicModel& model,
                                                      const Placement& placement,
                                                      const MatroidAnalysis& analysis, const GearTrain& train,
                                                      const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(analysis.solution.has_value());
  if (hasSlides(mechanism)) return slidesNotCovered(mechanism, translated("The equation of motion"));
  const LiveSolution& solution = *analysis.solution;
  GEARGRAPH_REQUIRE(solution.matrix.size() == solution.inputs.size() * solution.outputs.size());
  const auto exactMetres = metresPerUnit(mechanism);
  if (!exactMetres) {
    return Diagnostic{
        Code::unknownUnit,
        translated("Masses need lengths in metres, and \"%1\" is no unit of length that is known: "
                   "use mm, cm, m or in.",
                   {mechanism.unit}),
        {},
        {},
        0,
        0};
  }
  const double metres = exactMetres->toDouble();
  MechanismDynamics result;
  result.links = linkInertias(mechanism, placement, train, metres, stop);
  if (stop.stop_requested()) return std::nullopt;
  result.inputs = solution.inputs;
  DynamicTrain& moving = result.train;
  moving.tree = std::make_shared<const SpanningTree>(model.tree());
  moving.lines = turningLines(placement);
  for (TurningLine& line : moving.lines) line.point *= metres;
  moving.gains = gainsOf(solution);
  for (const LinkInertia& link : result.links) moving.links.push_back(link.body);
  if (mechanism.gravity) {
    for (std::size_t i = 0; i < 3; ++i)
      moving.gravity[static_cast<Eigen::Index>(i)] = (*mechanism.gravity)[i].value();
  }
  moving.loads = movingLoads(mechanism, placement, mechanism.loads, metres);
  if (!moving.lines.empty()) shift(moving, Eigen::Vector3d(moving.lines.front().point));
  return result;
}

}  // namespace geargraph
