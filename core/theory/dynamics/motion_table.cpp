#include "core/theory/dynamics/motion_table.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

/// The quantities of a sample with a value for each input, as they are named and found.
constexpr std::array<std::pair<const char*, Eigen::VectorXd MotionSample::*>, 4> kPerInput = {
    {{"angle", &MotionSample::angles},
     {"speed", &MotionSample::speeds},
     {"acceleration", &MotionSample::accelerations},
     {"torque", &MotionSample::torques}}};
constexpr std::array<std::pair<const char*, double MotionSample::*>, 3> kEnergies = {
    {{"kinetic", &MotionSample::kinetic},
     {"potential", &MotionSample::potential},
     {"work", &MotionSample::work}}};

}  // namespace

std::vector<std::string> motionColumns(std::span<const std::string> inputs) {
  std::vector<std::string> columns{"time"};
  for (const auto& [name, values] : kPerInput) {
    for (const std::string& input : inputs) columns.push_back(std::string(name) + ' ' + input);
  }
  for (const auto& [name, value] : kEnergies) columns.emplace_back(name);
  return columns;
}

std::vector<double> motionRow(const MotionSample& sample) {
  std::vector<double> values{sample.time};
  for (const auto& [name, vector] : kPerInput)
    values.insert(values.end(), (sample.*vector).begin(), (sample.*vector).end());
  for (const auto& [name, value] : kEnergies) values.push_back(sample.*value);
  return values;
}

std::string_view endName(SimulationEnd end) {
  switch (end) {
    case SimulationEnd::complete:
      return "complete";
    case SimulationEnd::atLimit:
      return "limit";
    case SimulationEnd::massless:
      return "massless";
    case SimulationEnd::unbounded:
      return "unbounded";
    case SimulationEnd::stopped:
      return "stopped";
  }
  return "";
}

std::string endSentence(SimulationEnd end, std::string_view limitJoint) {
  switch (end) {
    case SimulationEnd::atLimit:
      return translated("It ends where joint %1 reaches the end of its range.", {limitJoint});
    case SimulationEnd::massless:
      return translated("A motion of the inputs moves no mass: torques determine no acceleration.");
    case SimulationEnd::unbounded:
      return translated("It ends where speeds grow beyond what can be followed.");
    case SimulationEnd::complete:
    case SimulationEnd::stopped:
      break;
  }
  return {};
}

double energyDefect(const Simulation& simulation) {
  double most = 0;
  for (const MotionSample& sample : simulation.samples) {
    const MotionSample& first = simulation.samples.front();
    const double gained = sample.kinetic + sample.potential - first.kinetic - first.potential;
    const double defect = gained - (sample.work - first.work);
    if (std::abs(defect) > std::abs(most)) most = defect;
  }
  return most;
}

}  // namespace geargraph
