#include "core/theory/dynamics/equation_of_motion.h"

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

using SixVector = Eigen::Matrix<double, 6, 1>;

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

/// How a twist that moves along with `motion` changes.
SixVector motionCross(const SixVector& motion, const SixVector& twist) {
  SixVector result;
  result << motion.head<3>().cross(twist.head<3>()),
      motion.tail<3>().cross(twist.head<3>()) + motion.head<3>().cross(twist.tail<3>());
  return result;
}

/// How a momentum that moves along with `motion` changes.
SixVector forceCross(const SixVector& motion, const SixVector& momentum) {
  SixVector result;
  result << motion.head<3>().cross(momentum.head<3>()) + motion.tail<3>().cross(momentum.tail<3>()),
      motion.head<3>().cross(momentum.tail<3>());
  return result;
}

}  // namespace

TrainDynamics::TrainDynamics(DynamicTrain train)
    : m_train(std::move(train)),
      m_kinematics(*m_train.tree, m_train.lines),
      m_jointAngles(m_train.lines.size()),
      m_poses(m_train.links.size()),
      m_twists(m_train.links.size(), Twists::Zero(6, m_train.inputs())),
      m_screws(m_train.links.size(), SixVector::Zero()) {
  GEARGRAPH_REQUIRE(m_train.gains.rows() == static_cast<Eigen::Index>(m_train.lines.size()));
  GEARGRAPH_REQUIRE(static_cast<int>(m_train.links.size()) == m_train.tree->nodeCount());
}

void TrainDynamics::place(const Eigen::VectorXd& angles) {
  GEARGRAPH_REQUIRE(angles.size() == m_train.inputs());
  Eigen::Map<Eigen::VectorXd>(m_jointAngles.data(), m_train.gains.rows()) = m_train.gains * angles;
  m_kinematics.place(m_jointAngles, m_poses);
  const SpanningTree& tree = *m_train.tree;
  for (const LinkOrdinal link : tree.preorder().subspan(1)) {
    const auto at = static_cast<std::size_t>(link);
    const auto parent = static_cast<std::size_t>(tree.parent(link));
    const JointOrdinal joint = tree.jointToParent(link);
    const TurningLine& line = m_train.lines[joint];
    const Eigen::Vector3d direction =
        -tree.directionToGround(joint) * (m_poses[parent].linear() * line.direction);
    m_screws[at] << direction, (m_poses[parent] * line.point).cross(direction);
    m_twists[at] = m_twists[parent] + m_screws[at] * m_train.gains.row(joint);
  }
}

Eigen::Matrix<double, 6, 6> TrainDynamics::spatialInertia(LinkOrdinal link) const {
  const auto at = static_cast<std::size_t>(link);
  const MassProperties body = moved(m_train.links[at], m_poses[at]);
  const Eigen::Matrix3d first = body.mass * crossMatrix(body.center);
  Eigen::Matrix<double, 6, 6> inertia;
  inertia << body.inertia - first * crossMatrix(body.center), first, first.transpose(),
      body.mass * Eigen::Matrix3d::Identity();
  return inertia;
}

void TrainDynamics::addLoad(const MovingLoad& load) {
  if (load.joint >= 0) {
    m_equation.load += load.torque.x() * m_train.gains.row(load.joint).transpose();
    return;
  }
  const auto link = static_cast<std::size_t>(load.link);
  const Eigen::Vector3d point = m_poses[link] * load.point;
  SixVector wrench;
  wrench << m_poses[load.carrier].linear() * load.torque + point.cross(load.force), load.force;
  m_equation.load += m_twists[link].transpose() * wrench;
}

const EquationOfMotion& TrainDynamics::at(const Eigen::VectorXd& angles, const Eigen::VectorXd& speeds,
                                          const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(speeds.size() == m_train.inputs());
  place(angles);
  const SpanningTree& tree = *m_train.tree;
  const Eigen::VectorXd rates = m_train.gains * speeds;
  m_equation.inertia.setZero(m_train.inputs(), m_train.inputs());
  m_equation.bias.setZero(m_train.inputs());
  m_equation.load.setZero(m_train.inputs());
  m_equation.kinetic = 0;
  m_equation.potential = 0;
  ByLink<SixVector> accelerations(m_poses.size(), SixVector::Zero());  // where the inputs do not accelerate
  accelerations[0].tail<3>() = -m_train.gravity;  // weight is as if the ground accelerated upwards
  for (const LinkOrdinal link : tree.preorder().subspan(1)) {
    if (stop.stop_requested()) break;
    const auto i = static_cast<std::size_t>(link);
    const SixVector velocity = m_twists[i] * speeds;
    accelerations[i] = accelerations[tree.parent(link)] +
                       rates[tree.jointToParent(link)] * motionCross(velocity, m_screws[i]);
    const Eigen::Matrix<double, 6, 6> inertia = spatialInertia(link);
    const SixVector momentum = inertia * velocity;
    m_equation.inertia.noalias() += m_twists[i].transpose() * (inertia * m_twists[i]);
    m_equation.bias.noalias() +=
        m_twists[i].transpose() * (inertia * accelerations[i] + forceCross(velocity, momentum));
    m_equation.kinetic += 0.5 * velocity.dot(momentum);
    m_equation.potential -= m_train.links[i].mass * m_train.gravity.dot(m_poses[i] * m_train.links[i].center);
  }
  for (const MovingLoad& load : m_train.loads) addLoad(load);
  return m_equation;
}

Eigen::MatrixXd TrainDynamics::reflectedInertias(const Eigen::VectorXd& angles) {
  place(angles);
  Eigen::MatrixXd reflected(static_cast<Eigen::Index>(m_poses.size()), m_train.inputs());
  reflected.row(0).setZero();
  for (std::size_t link = 1; link < m_poses.size(); ++link) {
    const Twists momenta = spatialInertia(static_cast<int>(link)) * m_twists[link];
    reflected.row(static_cast<Eigen::Index>(link)) = m_twists[link].cwiseProduct(momenta).colwise().sum();
  }
  return reflected;
}

}  // namespace geargraph
