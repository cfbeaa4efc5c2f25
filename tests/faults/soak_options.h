#pragma once

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace geargraph::test {

/// How long a soak program goes on: `--seed N --runs N` or `--seed N --minutes M`.
class SoakOptions {
 public:
  SoakOptions(int count, char** words, long runs) : m_runs(runs) {
    for (int i = 1; i + 1 < count; i += 2) {
      const std::string_view name = words[i];
      if (name == "--seed") seed = static_cast<std::uint64_t>(std::atoll(words[i + 1]));
      if (name == "--runs") m_runs = std::atol(words[i + 1]);
      if (name == "--minutes") {
        m_runs = 0;
        m_end += std::chrono::duration_cast<Clock::duration>(
            std::chrono::duration<double, std::ratio<60>>(std::atof(words[i + 1])));
      }
    }
  }
  /// Is another run due?
  [[nodiscard]] bool goesOn(long runs) const { return m_runs > 0 ? runs < m_runs : Clock::now() < m_end; }

  std::uint64_t seed = 1;

 private:
  using Clock = std::chrono::steady_clock;
  long m_runs;  ///< 0: until m_end
  Clock::time_point m_end = Clock::now();
};

}  // namespace geargraph::test
