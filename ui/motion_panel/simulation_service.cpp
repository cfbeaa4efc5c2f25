#include "ui/motion_panel/simulation_service.h"

#include <algorithm>

namespace geargraph {
namespace {

void simulateOne(const SimulationRequest& request, const SimulationService::Responder& respond) {
  std::stop_source halt = request.halt;
  const std::stop_callback superseded(respond.stop(), [&halt] { halt.request_stop(); });
  TrainDynamics dynamics(request.train->train);
  auto motion = std::make_shared<SimulatedMotion>();
  motion->train = request.train;
  motion->simulation = simulate(dynamics, request.options, halt.get_token(),
                                [&](double time) { request.reached->store(time); });
  respond(std::move(motion));
}

}  // namespace

SimulationService::SimulationService(QObject* parent) : Service(&simulateOne, parent) {}

void SimulationService::start(MechanismDynamicsPtr train, SimulationOptions options) {
  m_running = {std::move(train), std::move(options), std::make_shared<std::atomic<double>>(0), {}};
  request(m_running);
}

void SimulationService::halt() {
  m_running.halt.request_stop();
}

void SimulationService::forget() {
  if (isRunning()) cancel();
  if (answer()) setAnswer(nullptr);
}

double SimulationService::progress() const {
  return m_running.reached ? std::clamp(*m_running.reached / m_running.options.seconds, 0., 1.) : 0;
}

}  // namespace geargraph
