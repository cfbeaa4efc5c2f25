#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace geargraph::inline stage {

/// Angles of the inputs over time, known at some times: a motion whose speeds change, as forward dynamics
/// gives it.
class InputTrajectory {
 public:
  struct Sample {
    double time = 0;             ///< s
    std::vector<double> angles;  ///< rad, one an input; at 0 the reference pose
    std::vector<double> speeds;  ///< rad/s
  };

  /// @pre at least one sample, as many angles and speeds in each; times grow and begin with 0
  explicit InputTrajectory(std::vector<Sample> samples);

  [[nodiscard]] std::size_t inputs() const { return m_samples.front().angles.size(); }
  /// How long it takes, s; 0 with one sample.
  [[nodiscard]] double seconds() const { return m_samples.back().time; }
  [[nodiscard]] const std::vector<Sample>& samples() const { return m_samples; }

  /// Between samples by the cubic with their angles and speeds, before the first and after the last as there.
  /// Cost: the logarithm of the samples.
  [[nodiscard]] Sample at(double time) const;

 private:
  std::vector<Sample> m_samples;
};

using InputTrajectoryPtr = std::shared_ptr<const InputTrajectory>;

}  // namespace geargraph::inline stage
