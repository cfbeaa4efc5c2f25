#pragma once

#include <atomic>
#include <memory>

#include "core/theory/dynamics/simulation.h"
#include "ui/motion_panel/dynamics_service.h"

namespace geargraph {

struct SimulationRequest {
  MechanismDynamicsPtr train;
  SimulationOptions options;
  std::shared_ptr<std::atomic<double>> reached;  ///< simulated time, s, updated while it runs
  std::stop_source halt;  ///< ends the simulation early; the answer is the motion so far
};

/// The motion of a train under torques.
struct SimulatedMotion {
  MechanismDynamicsPtr train;
  Simulation simulation;
};
using SimulatedMotionPtr = std::shared_ptr<const SimulatedMotion>;

/// Runs forward dynamics on a background thread.
class SimulationService final : public Service<SimulationRequest, SimulatedMotionPtr> {
 public:
  explicit SimulationService(QObject* parent = nullptr);

  void start(MechanismDynamicsPtr train, SimulationOptions options);
  /// Ends the current simulation early; its answer is the motion so far.
  void halt();
  /// Cancels the simulation and discards the last answer.
  void forget();
  [[nodiscard]] bool isRunning() const { return !isComplete(); }
  /// The fraction done, 0..1.
  [[nodiscard]] double progress() const;

 private:
  SimulationRequest m_running;
};

}  // namespace geargraph
