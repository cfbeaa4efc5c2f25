#include "core/presentation/scene3d/traced_path.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr std::size_t kFirstSteps = 256;
constexpr std::size_t kMaxPoses = 1 << 17;
constexpr double kFineEnough = 1e-4;

TracedPath sampled(const MechanismScene& stage, const TracedPoint& point, std::span<const double> start,
                   double seconds, const InputTrajectory* trajectory, std::size_t steps,
                   const std::stop_token& stop) {
  TracedPath path;
  std::vector<Pose> poses(stage.scene.instances.size());
  std::vector<double> angles(start.size());
  for (std::size_t step = 0; step <= steps && !stop.stop_requested(); ++step) {
    const double time = seconds * static_cast<double>(step) / static_cast<double>(steps);
    if (trajectory != nullptr) angles = trajectory->at(time).angles;
    for (std::size_t k = 0; k < angles.size(); ++k)
      angles[k] = start[k] + (trajectory != nullptr ? angles[k] : stage.inputSpeeds[k] * time);
    stage.place(angles, poses);
    Eigen::Vector3d at = poses[point.instance] * point.place;
    if (point.watcher) {
      at = stage.scene.instances[*point.watcher].pose * (poses[*point.watcher].inverse() * at);
    }
    if (step > 0) path.length += (at - path.points.back()).norm();
    path.times.push_back(time);
    path.points.push_back(at);
  }
  return path;
}

/// An empty field where speeds near the end of the doubles have no finite value here.
void appendNumber(std::string& text, double value) {
  if (!std::isfinite(value)) return;
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

}  // namespace

TracedPath tracedPath(const MechanismScene& stage, const TracedPoint& point, std::span<const double> start,
                      double seconds, const InputTrajectory* trajectory, const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(stage.place && seconds > 0 && start.size() == stage.inputSpeeds.size());
  GEARGRAPH_REQUIRE(trajectory == nullptr || trajectory->inputs() == start.size());
  std::size_t steps = kFirstSteps;
  double gain = 0;
  TracedPath path = sampled(stage, point, start, seconds, trajectory, steps, stop);
  while (2 * steps * stage.scene.instances.size() <= kMaxPoses && !stop.stop_requested()) {
    steps *= 2;
    TracedPath finer = sampled(stage, point, start, seconds, trajectory, steps, stop);
    gain = finer.length - path.length;
    path = std::move(finer);
    if (gain <= kFineEnough * path.length) break;
  }
  path.length += gain / 3;  // chords of half the length fall short by a quarter
  return path;
}

std::string pathCsv(const TracedPath& path, const std::string& unit) {
  std::string text = "time s,x " + unit + ",y " + unit + ",z " + unit + "\r\n";
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    appendNumber(text, path.times[i]);
    for (const double coordinate : path.points[i]) {
      text += ',';
      appendNumber(text, coordinate);
    }
    text += "\r\n";
  }
  return text;
}

}  // namespace geargraph
