// Masses, the equation of motion in the inputs, and the motion that torques cause.

#include <array>
#include <cmath>

#include "app/python/bindings/snapshot.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/theory/dynamics/dynamics_report.h"
#include "core/theory/pose/joint_limits.h"

namespace geargraph::python {
namespace {

using Numbers = std::vector<double>;

/// A finite number for each input, as a vector.
Eigen::VectorXd vectorFrom(const Numbers& numbers, Eigen::Index inputs, const char* what) {
  if (static_cast<Eigen::Index>(numbers.size()) != inputs)
    throw py::value_error(std::string(what) + ": a number for each input is needed.");
  for (const double number : numbers) {
    if (!std::isfinite(number)) throw py::value_error(std::string(what) + " have to be finite.");
  }
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), inputs);
}

template <class Matrix>
py::bytes packedMatrix(const Matrix& matrix) {
  Numbers numbers;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) numbers.push_back(matrix(row, column));
  }
  return packed(numbers);
}

std::string_view endName(SimulationEnd end) {
  constexpr std::array<std::string_view, 5> kNames = {"complete", "limit", "massless", "unbounded",
                                                      "stopped"};
  return kNames.at(static_cast<std::size_t>(end));
}

/// The dynamics of a mechanism as engaged; immutable, any thread may ask.
class Dynamics {
 public:
  explicit Dynamics(const Snapshot& snapshot) : m_snapshot(snapshot.live()) {
    const MatroidAnalysis& matroid = snapshot.matroid(true);
    if (matroid.solution->inputs.size() * matroid.solution->outputs.size() > LiveSolution::kMaxLiveEntries)
      raise("limit", "Dynamics is computed for up to " + std::to_string(LiveSolution::kMaxLiveEntries) +
                         " entries of the solution.");
    m_dynamics = valueOrRaise(interruptible([&](const std::stop_token& stop) -> Expected<MechanismDynamics> {
      const auto train = m_snapshot->geometry->train(stop);
      auto made = train ? dynamicsOf(*m_snapshot->mechanism, *m_snapshot->kinematics->model,
                                     m_snapshot->kinematics->placement(), matroid, *train, stop)
                        : std::nullopt;
      // A stop raises KeyboardInterrupt, so that what is returned then is not looked at.
      return made ? *std::move(made) : Expected<MechanismDynamics>(MechanismDynamics());
    }));
  }

  [[nodiscard]] std::vector<int> inputs() const { return m_dynamics.inputs; }
  [[nodiscard]] Eigen::Index count() const { return m_dynamics.train.inputs(); }

  [[nodiscard]] py::bytes gravity() const { return packedMatrix(m_dynamics.train.gravity); }

  /// By link: mass, centre, inertia (xx, yy, zz, xy, xz, yz), where they come from.
  [[nodiscard]] py::list links() const {
    py::list rows;
    for (const LinkInertia& link : m_dynamics.links) {
      const Eigen::Vector3d& center = link.body.center;
      const Eigen::Matrix3d& inertia = link.body.inertia;
      rows.append(py::make_tuple(link.body.mass, py::make_tuple(center.x(), center.y(), center.z()),
                                 py::make_tuple(inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1),
                                                inertia(0, 2), inertia(1, 2)),
                                 massSourceName(link.source)));
    }
    return rows;
  }

  /// M, h, loads, reflected inertias; kinetic and potential energy.
  [[nodiscard]] py::tuple equation(const Numbers& angles, const Numbers& speeds) const {
    const auto at = vectorFrom(angles, count(), "Angles");
    const auto turning = vectorFrom(speeds, count(), "Speeds");
    TrainDynamics train(m_dynamics.train);
    const EquationOfMotion& made = train.at(at, turning);
    return py::make_tuple(packedMatrix(made.inertia), packedMatrix(made.bias), packedMatrix(made.load),
                          packedMatrix(train.reflectedInertias(at)), made.kinetic, made.potential);
  }

  /// None where a motion moves no mass.
  [[nodiscard]] std::optional<py::bytes> accelerations(const Numbers& angles, const Numbers& speeds,
                                                       const Numbers& torques) const {
    TrainDynamics train(m_dynamics.train);
    const EquationOfMotion& made =
        train.at(vectorFrom(angles, count(), "Angles"), vectorFrom(speeds, count(), "Speeds"));
    const auto found = accelerationsFor(made, vectorFrom(torques, count(), "Torques"));
    return found ? std::optional(packedMatrix(*found)) : std::nullopt;
  }

  /// How it ended, the joint at its limit or -1, and the samples row by row: time, angles, speeds,
  /// accelerations, torques, kinetic and potential energy, work.
  [[nodiscard]] py::tuple simulate(const Numbers& torques, const Numbers& damping, const Numbers& angles,
                                   const Numbers& speeds, double seconds, double interval) const {
    SimulationOptions options;
    options.angles = vectorFrom(angles, count(), "Angles");
    options.speeds = vectorFrom(speeds, count(), "Speeds");
    const auto torque = vectorFrom(torques, count(), "Torques");
    const auto lessPerSpeed = vectorFrom(damping, count(), "Dampings");
    if ((lessPerSpeed.array() < 0).any()) throw py::value_error("Damping is at least 0.");
    for (Eigen::Index i = 0; i < count(); ++i) options.motors.push_back({torque[i], lessPerSpeed[i]});
    constexpr double kShortest = 1e-6, kMaxLength = 1e6;
    for (const double time : {seconds, interval}) {
      if (!(time >= kShortest && time <= kMaxLength))
        throw py::value_error("A motion and its interval last 1e-6 to 1e6 seconds.");
    }
    if (seconds / interval >= static_cast<double>(kMaxSamples))
      throw py::value_error("A motion has at most a million samples.");
    options.seconds = seconds;
    options.interval = interval;
    options.limits = angleLimits(*m_snapshot->mechanism);
    const Simulation made = interruptible([&](const std::stop_token& stop) {
      TrainDynamics train(m_dynamics.train);
      return geargraph::simulate(train, options, stop);
    });
    return py::make_tuple(endName(made.end), made.limitJoint, packed(rowsOf(made)));
  }

 private:
  static Numbers rowsOf(const Simulation& simulation) {
    Numbers rows;
    for (const MotionSample& sample : simulation.samples) {
      rows.push_back(sample.time);
      for (const Eigen::VectorXd* part :
           {&sample.angles, &sample.speeds, &sample.accelerations, &sample.torques})
        rows.insert(rows.end(), part->begin(), part->end());
      rows.insert(rows.end(), {sample.kinetic, sample.potential, sample.work});
    }
    return rows;
  }

  SnapshotPtr m_snapshot;
  MechanismDynamics m_dynamics;
};

}  // namespace

void addDynamics(py::module_& module) {
  py::class_<Dynamics>(module, "Dynamics")
      .def(py::init([](const Snapshot& snapshot) { return std::make_unique<Dynamics>(snapshot); }))
      .def("inputs", &Dynamics::inputs)
      .def("gravity", &Dynamics::gravity)
      .def("links", &Dynamics::links)
      .def("equation", &Dynamics::equation)
      .def("accelerations", &Dynamics::accelerations)
      .def("simulate", &Dynamics::simulate);
}

}  // namespace geargraph::python
