#include "core/presentation/scene3d/input_trajectory.h"

#include <algorithm>

#include "core/foundations/base/contract.h"

namespace geargraph {

InputTrajectory::InputTrajectory(std::vector<Sample> samples) : m_samples(std::move(samples)) {
  GEARGRAPH_REQUIRE(!m_samples.empty() && m_samples.front().time == 0);
  for (std::size_t i = 0; i < m_samples.size(); ++i) {
    const Sample& sample = m_samples[i];
    GEARGRAPH_REQUIRE(sample.angles.size() == inputs() && sample.speeds.size() == inputs());
    GEARGRAPH_REQUIRE(i == 0 || sample.time > m_samples[i - 1].time);
  }
}

InputTrajectory::Sample InputTrajectory::at(double time) const {
  const auto after =
      std::upper_bound(m_samples.begin(), m_samples.end(), time,
                       [](double moment, const Sample& sample) { return moment < sample.time; });
  if (after == m_samples.begin()) return m_samples.front();
  if (after == m_samples.end()) return m_samples.back();
  const Sample& from = *(after - 1);
  const Sample& to = *after;
  const double step = to.time - from.time;
  const double s = (time - from.time) / step;
  Sample between{time, from.angles, from.speeds};
  for (std::size_t k = 0; k < inputs(); ++k) {
    // Hermite's cubic about its value at `from`: no digits are lost where angles are large.
    const double rise = to.angles[k] - from.angles[k];
    const double start = step * from.speeds[k];
    const double end = step * to.speeds[k];
    const double square = 3 * rise - 2 * start - end;
    const double cube = start + end - 2 * rise;
    between.angles[k] += s * (start + s * (square + s * cube));
    between.speeds[k] = (start + s * (2 * square + 3 * s * cube)) / step;
  }
  return between;
}

}  // namespace geargraph
