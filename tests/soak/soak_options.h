#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace geargraph::soak {

/// What both programs of this folder are told: `--seed N`, and how long to go on.
struct SoakOptions {
  std::uint64_t seed = 1;
  std::optional<long> count;      ///< `--edits N`, `--gestures N`
  std::optional<double> minutes;  ///< `--minutes M`
  double slack = 1;               ///< `--slack F`: factor by which stalls may be longer, on a loaded machine
  bool stacks = false;            ///< `--stacks`: a long stall is printed with what it was at
  std::vector<std::string> documents;

  [[nodiscard]] bool isEnough(long done, double seconds) const {
    return (count && done >= *count) || (minutes && seconds >= *minutes * 60);
  }
};

/// std::nullopt for a wrong command line. `counted`: the option that gives a number, "--edits".
[[nodiscard]] std::optional<SoakOptions> readOptions(int argc, char** argv, const std::string& counted);

}  // namespace geargraph::soak
