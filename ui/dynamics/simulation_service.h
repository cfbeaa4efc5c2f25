#pragma once

#include <atomic>
#include <memory>

#include "core/theory/dynamics/simulation.h"
#include "ui/dynamics/dynamics_service.h"

namespace geargraph::inline ui_dynamics {

struct SimulationRequest {
  MechanismDynamicsPtr train;
  SimulationOptions options;
  std::shared_ptr<std::atomic<double>> reached;  ///< s of the motion, written as it is followed
  std::stop_source halt;  ///< ends the motion where it is; what is known of it is the answer
};

/// The motion of a train under torques.
struct SimulatedMotion {
  MechanismDynamicsPtr train;
  Simulation simulation;
};
using SimulatedMotionPtr = std::shared_ptr<const SimulatedMotion>;

/// Follows the motion that torques cause, on a thread of its own.
class SimulationService final : public Service<SimulationRequest, SimulatedMotionPtr> {
 public:
  explicit SimulationService(QObject* parent = nullptr);

  void start(MechanismDynamicsPtr train, SimulationOptions options);
  /// Ends the motion under way; its answer is what is known of it.
  void halt();
  /// No motion is known or under way any more.
  void forget();
  [[nodiscard]] bool isRunning() const { return !isComplete(); }
  /// How much of the motion is done, 0..1.
  [[nodiscard]] double progress() const;

 private:
  SimulationRequest m_running;
};

}  // namespace geargraph::inline ui_dynamics
