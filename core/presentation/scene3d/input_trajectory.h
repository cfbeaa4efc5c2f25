#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace geargraph {

/// Sampled angles of the inputs over time: a motion with varying speeds, as from forward dynamics.
class InputTrajectory {
 public:
  struct Sample {
    double time = 0;             ///< s
    std::vector<double> angles;  ///< rad, one per input; 0 is the reference pose
    std::vector<double> speeds;  ///< rad/s
  };

  /// @pre at least one sample, as many angles and speeds in each; times grow and begin with 0
  explicit InputTrajectory(std::vector<Sample> samples);

  [[nodiscard]] std::size_t inputs() const { return m_samples.front().angles.size(); }
  /// The duration, s; 0 with one sample.
  [[nodiscard]] double seconds() const { return m_samples.back().time; }
  [[nodiscard]] const std::vector<Sample>& samples() const { return m_samples; }

  /// Interpolated by the cubic Hermite polynomial between samples, constant before the first and after the
  /// last.
  /// Cost: the logarithm of the samples.
  [[nodiscard]] Sample at(double time) const;

 private:
  std::vector<Sample> m_samples;
};

using InputTrajectoryPtr = std::shared_ptr<const InputTrajectory>;

}  // namespace geargraph
