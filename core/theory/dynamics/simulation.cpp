#include "core/theory/dynamics/simulation.h"

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

namespace odeint = boost::numeric::odeint;

/// The angles of the inputs, their speeds, and the work of motors and loads.
using State = std::vector<double>;

class Run {
 public:
  Run(TrainDynamics& dynamics, const SimulationOptions& options)
      : m_dynamics(dynamics), m_options(options), m_inputs(dynamics.train().inputs()) {
    GEARGRAPH_REQUIRE(static_cast<Eigen::Index>(options.motors.size()) == m_inputs);
    GEARGRAPH_REQUIRE(options.angles.size() == m_inputs && options.speeds.size() == m_inputs);
    GEARGRAPH_REQUIRE(options.seconds > 0 && options.interval > 0 && options.tolerance > 0);
    GEARGRAPH_REQUIRE(options.seconds / options.interval < static_cast<double>(kMaxSamples));
  }

  Simulation result(const std::stop_token& stop, const std::function<void(double)>& progress) {
    State state(static_cast<std::size_t>(2 * m_inputs + 1));
    Eigen::Map<Eigen::VectorXd>(state.data(), m_inputs) = m_options.angles;
    Eigen::Map<Eigen::VectorXd>(state.data() + m_inputs, m_inputs) = m_options.speeds;
    if (!addSample(0, state)) return ended(SimulationEnd::massless);
    if (const JointOrdinal joint = beyondLimit(state); joint >= 0)
      return ended(SimulationEnd::atLimit, joint);
    auto stepper = odeint::make_dense_output(m_options.tolerance, m_options.tolerance,
                                             odeint::runge_kutta_dopri5<State>());
    stepper.initialize(state, 0, std::min(m_options.interval, m_options.seconds));
    const auto derivative = [this](const State& at, State& change, double) { derive(at, change); };
    for (int steps = 0; m_time < m_options.seconds; ++steps) {
      if (stop.stop_requested()) return ended(SimulationEnd::stopped);
      if (steps == kMaxSteps) return ended(SimulationEnd::unbounded);
      try {
        stepper.do_step(derivative);
      } catch (const odeint::odeint_error&) {  // no step is small enough
        return ended(SimulationEnd::unbounded);
      }
      if (m_isMassless) return ended(SimulationEnd::massless);
      if (!isFinite(stepper.current_state())) return ended(SimulationEnd::unbounded);
      if (const auto end = sampleStep(stepper)) return ended(*end, m_limitJoint);
      if (progress) progress(m_time);
    }
    return ended(SimulationEnd::complete);
  }

 private:
  [[nodiscard]] Eigen::VectorXd anglesOf(const State& state) const {
    return Eigen::Map<const Eigen::VectorXd>(state.data(), m_inputs);
  }
  [[nodiscard]] Eigen::VectorXd speedsOf(const State& state) const {
    return Eigen::Map<const Eigen::VectorXd>(state.data() + m_inputs, m_inputs);
  }
  [[nodiscard]] Eigen::VectorXd torquesAt(const Eigen::VectorXd& speeds) const {
    Eigen::VectorXd torques(m_inputs);
    for (Eigen::Index i = 0; i < m_inputs; ++i)
      torques[i] = m_options.motors[static_cast<std::size_t>(i)].torqueAt(speeds[i]);
    return torques;
  }
  static bool isFinite(const State& state) {
    return std::all_of(state.begin(), state.end(), [](double value) { return std::isfinite(value); });
  }

  void derive(const State& state, State& change) {
    const Eigen::VectorXd speeds = speedsOf(state);
    const EquationOfMotion& equation = m_dynamics.at(anglesOf(state), speeds);
    const Eigen::VectorXd torques = torquesAt(speeds);
    const auto accelerations = accelerationsFor(equation, torques);
    m_isMassless = m_isMassless || !accelerations;
    Eigen::Map<Eigen::VectorXd>(change.data(), m_inputs) = speeds;
    Eigen::Map<Eigen::VectorXd>(change.data() + m_inputs, m_inputs) =
        accelerations.value_or(Eigen::VectorXd::Zero(m_inputs));
    change.back() = (torques + equation.load).dot(speeds);
  }

  bool addSample(double time, const State& state) {
    MotionSample sample;
    sample.time = time;
    sample.angles = anglesOf(state);
    sample.speeds = speedsOf(state);
    sample.torques = torquesAt(sample.speeds);
    const EquationOfMotion& equation = m_dynamics.at(sample.angles, sample.speeds);
    auto accelerations = accelerationsFor(equation, sample.torques);
    if (!accelerations) return false;
    sample.accelerations = std::move(*accelerations);
    sample.kinetic = equation.kinetic;
    sample.potential = equation.potential;
    sample.work = state.back();
    m_result.samples.push_back(std::move(sample));
    return true;
  }

  /// The samples within the step that was made, up to the end of the motion.
  template <class Stepper>
  std::optional<SimulationEnd> sampleStep(const Stepper& stepper) {
    const double end = std::min(stepper.current_time(), m_options.seconds);
    double beyond = 0;
    const bool isLimited = firstBeyond(stepper, m_time, end, beyond);
    const double until = isLimited ? beyond : end;
    State state(static_cast<std::size_t>(2 * m_inputs + 1));
    for (;;) {
      const double next = static_cast<double>(m_taken + 1) * m_options.interval;
      if (next > until) break;
      stepper.calc_state(next, state);
      if (!addSample(next, state)) return SimulationEnd::massless;
      ++m_taken;
    }
    m_time = until;
    const bool isLast = isLimited || end == m_options.seconds;
    if (isLast && m_result.samples.back().time < until) {
      stepper.calc_state(until, state);
      if (!addSample(until, state)) return SimulationEnd::massless;
    }
    return isLimited ? std::optional(SimulationEnd::atLimit) : std::nullopt;
  }

  /// The first time of the step at which a joint is beyond its range, by bisection between points of the
  /// interpolation.
  template <class Stepper>
  bool firstBeyond(const Stepper& stepper, double from, double to, double& time) {
    if (m_options.limits.empty()) return false;
    constexpr int kPoints = 8;  // a joint that leaves its range and comes back within an eighth is not seen
    State state(static_cast<std::size_t>(2 * m_inputs + 1));
    double inside = from;
    for (int i = 1; i <= kPoints; ++i) {
      const double at = i == kPoints ? to : from + (to - from) * i / kPoints;
      stepper.calc_state(at, state);
      if (beyondLimit(state) < 0) {
        inside = at;
        continue;
      }
      double outside = at;
      constexpr int kBisections = 50;
      for (int k = 0; k < kBisections; ++k) {
        const double middle = (inside + outside) / 2;
        stepper.calc_state(middle, state);
        (beyondLimit(state) < 0 ? inside : outside) = middle;
      }
      stepper.calc_state(outside, state);
      m_limitJoint = beyondLimit(state);
      time = outside;
      return true;
    }
    return false;
  }

  /// A joint beyond its range; -1: none. At the end of its range it is not beyond it.
  [[nodiscard]] int beyondLimit(const State& state) const {
    constexpr double kRounding = 1e-12;
    const Eigen::VectorXd angles = m_dynamics.train().gains * anglesOf(state);
    for (std::size_t joint = 0; joint < m_options.limits.size(); ++joint) {
      const AngleLimits& limits = m_options.limits[joint];
      const double angle = angles[static_cast<Eigen::Index>(joint)];
      const double rounding = kRounding * (1 + std::abs(angle));
      if (angle < limits.low - rounding || angle > limits.high + rounding) return static_cast<int>(joint);
    }
    return -1;
  }

  Simulation ended(SimulationEnd end, JointOrdinal limitJoint = -1) {
    m_result.end = end;
    m_result.limitJoint = limitJoint;
    return std::move(m_result);
  }

  TrainDynamics& m_dynamics;
  const SimulationOptions& m_options;
  Eigen::Index m_inputs;
  Simulation m_result;
  double m_time = 0;
  long m_taken = 0;  ///< samples after that at time 0
  JointOrdinal m_limitJoint = -1;
  bool m_isMassless = false;
};

}  // namespace

Simulation simulate(TrainDynamics& dynamics, const SimulationOptions& options, const std::stop_token& stop,
                    const std::function<void(double)>& progress) {
  return Run(dynamics, options).result(stop, progress);
}

std::optional<Eigen::VectorXd> accelerationsFor(const EquationOfMotion& equation,
                                                const Eigen::VectorXd& motorTorques) {
  const Eigen::VectorXd diagonal = equation.inertia.diagonal();
  if (diagonal.size() > 0 && diagonal.minCoeff() <= 0) return std::nullopt;
  // Inertias of motors differ by squares of ratios: compared with 1 each.
  const Eigen::VectorXd scale = diagonal.cwiseSqrt().cwiseInverse();
  const Eigen::LDLT<Eigen::MatrixXd> factors(
      Eigen::MatrixXd(scale.asDiagonal() * equation.inertia * scale.asDiagonal()));
  constexpr double kSingular = 1e-13;
  if (diagonal.size() > 0 && factors.vectorD().minCoeff() <= kSingular) return std::nullopt;
  const Eigen::VectorXd torques = motorTorques + equation.load - equation.bias;
  return scale.cwiseProduct(factors.solve(scale.cwiseProduct(torques)));
}

}  // namespace geargraph
