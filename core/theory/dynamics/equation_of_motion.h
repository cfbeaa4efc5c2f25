#pragma once

#include <Eigen/Dense>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/machine/solids/mass_properties.h"
#include "core/theory/pose/forward_kinematics.h"

namespace geargraph {

/// A load that acts on a moving train. Torques N m, forces N, lengths m; directions and points in the
/// reference pose, base frame.
struct MovingLoad {
  /// The turning joint that it acts in, by its tail on its head; -1: it acts on `link`.
  JointOrdinal joint = -1;
  LinkOrdinal link = 0;
  /// In a joint: the torque is its first component. On a link: a couple, whose direction moves with
  /// `carrier`.
  Eigen::Vector3d torque{0, 0, 0};
  LinkOrdinal carrier = 0;
  /// Keeps its direction in the base frame; its point moves with the link.
  Eigen::Vector3d force{0, 0, 0};
  Eigen::Vector3d point{0, 0, 0};
};

/// A train of rigid links with the data that dynamics needs. Lengths in m.
struct DynamicTrain {
  SpanningTreePtr tree;
  ByJoint<TurningLine> lines;        ///< reference pose
  Eigen::MatrixXd gains;             ///< K, joints x inputs: theta_joint = K theta_inputs
  ByLink<MassProperties> links;      ///< reference pose; that of the ground is not used
  Eigen::Vector3d gravity{0, 0, 0};  ///< acceleration of free fall
  std::vector<MovingLoad> loads;

  [[nodiscard]] Eigen::Index inputs() const { return gains.cols(); }
};

/// The equation of motion in the inputs, at one pose and speed:
///     M theta'' + h = tau + load,
/// with theta the angles of the inputs and tau the torques of their motors, by the tail of the joint on its
/// head.
struct EquationOfMotion {
  /// M_E = sum over the links of J_l^T diag(m, I) J_l, E x E, kg m²: symmetric, positive semidefinite.
  Eigen::MatrixXd inertia;
  /// h: the torques that constant speeds need, against Coriolis and centrifugal forces and weight; N m.
  Eigen::VectorXd bias;
  Eigen::VectorXd load;  ///< of the loads, N m
  double kinetic = 0;    ///< energy, J
  double potential = 0;  ///< of weight, J; 0 with all centres of mass at the origin of `lines`
};

/// Evaluates the equation of motion; reuses its buffers from one call to the next, so it is not thread-safe.
class TrainDynamics {
 public:
  explicit TrainDynamics(DynamicTrain train);

  [[nodiscard]] const DynamicTrain& train() const { return m_train; }

  /// At these angles and speeds of the inputs (rad, rad/s). Identities: M is the Hessian of the kinetic
  /// energy by the speeds; d(kinetic + potential)/dt = (tau + load) . theta'.
  /// Valid until the next call; the result is meaningless if `stop` was requested meanwhile.
  /// Cost: O(n E²).
  /// @pre an angle and a speed for each input
  const EquationOfMotion& at(const Eigen::VectorXd& angles, const Eigen::VectorXd& speeds,
                             const std::stop_token& stop = {});

  /// The inertia of each link reflected to each motor while the other motors are at rest, links x inputs, kg
  /// m²: for a link that turns about one axis its moment of inertia times the square of its ratio. The sum of
  /// a column is the diagonal entry of M.
  /// Cost: O(n E).
  [[nodiscard]] Eigen::MatrixXd reflectedInertias(const Eigen::VectorXd& angles);

 private:
  using Twists = Eigen::Matrix<double, 6, Eigen::Dynamic>;  ///< angular; linear of the point at the origin
  using Twist = Eigen::Matrix<double, 6, 1>;

  void place(const Eigen::VectorXd& angles);
  [[nodiscard]] Eigen::Matrix<double, 6, 6> spatialInertia(LinkOrdinal link) const;
  void addLoad(const MovingLoad& load);

  DynamicTrain m_train;
  ForwardKinematics m_kinematics;
  std::vector<double> m_jointAngles;
  ByLink<Eigen::Isometry3d> m_poses;
  ByLink<Twists> m_twists;  ///< the twist for unit speeds of the inputs
  ByLink<Twist> m_screws;   ///< of its joint towards the ground, for unit rate of the joint
  EquationOfMotion m_equation;
};

}  // namespace geargraph
