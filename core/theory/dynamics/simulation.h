#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/theory/dynamics/equation_of_motion.h"
#include "core/theory/pose/joint_limits.h"

namespace geargraph {

/// The motor of an input: tau = torque - damping * speed. With damping = torque / no-load speed it is a
/// direct-current motor at constant voltage.
struct Motor {
  double torque = 0;   ///< N m, by the tail of its joint on the head
  double damping = 0;  ///< N m s, at least 0

  [[nodiscard]] double torqueAt(double speed) const { return torque - damping * speed; }
};

struct SimulationOptions {
  std::vector<Motor> motors;    ///< by input
  Eigen::VectorXd angles;       ///< at time 0, of the inputs, rad
  Eigen::VectorXd speeds;       ///< at time 0, rad/s
  double seconds = 1;           ///< duration, above 0
  double interval = 0.01;       ///< between samples, s
  double tolerance = 1e-9;      ///< of a step, relative and (rad, rad/s, J) absolute
  ByJoint<AngleLimits> limits;  ///< empty: none
};

/// The train at one time.
struct MotionSample {
  double time = 0;                ///< s
  Eigen::VectorXd angles;         ///< of the inputs, rad
  Eigen::VectorXd speeds;         ///< rad/s
  Eigen::VectorXd accelerations;  ///< rad/s²
  Eigen::VectorXd torques;        ///< of the motors, N m
  double kinetic = 0;             ///< J
  double potential = 0;           ///< J
  double work = 0;                ///< of motors and loads since time 0, J
};

enum class SimulationEnd : std::uint8_t {
  complete,
  atLimit,    ///< a joint reached the end of its range
  massless,   ///< a motion of the inputs moves no mass, so torques determine no acceleration
  unbounded,  ///< speeds beyond what doubles follow, or more than kMaxSteps steps
  stopped,    ///< `stop` was requested
};

struct Simulation {
  std::vector<MotionSample> samples;  ///< at time 0 and after every interval; the last where it ended
  SimulationEnd end = SimulationEnd::complete;
  JointOrdinal limitJoint = -1;  ///< with atLimit
};

constexpr int kMaxSteps = 2'000'000;
constexpr std::size_t kMaxSamples = 1'000'000;

/// Forward dynamics: the motion that the motors' torques, the loads and weight cause from a start. Integrated
/// by the method of Dormand and Prince of order 5 with adaptive steps; samples are interpolated to order 4,
/// and the time at which a joint reaches its limit is found on the same interpolation. `progress`, if given,
/// is called with the time reached.
///
/// Identity: kinetic + potential - work is the same at all samples, but for the tolerance.
/// Cost: a few steps per second of free motion, more with high speeds or strong damping; a step evaluates
/// TrainDynamics::at() six times and solves an E x E system each time.
/// @pre a motor, an angle and a speed for each input; seconds, interval and tolerance above 0; at most
///      kMaxSamples samples
[[nodiscard]] Simulation simulate(TrainDynamics& dynamics, const SimulationOptions& options,
                                  const std::stop_token& stop = {},
                                  const std::function<void(double)>& progress = {});

/// The accelerations for these torques (motors and loads), by M theta'' = torques - h. std::nullopt if M is
/// singular to rounding: a motion moves no mass.
[[nodiscard]] std::optional<Eigen::VectorXd> accelerationsFor(const EquationOfMotion& equation,
                                                              const Eigen::VectorXd& motorTorques);

}  // namespace geargraph
