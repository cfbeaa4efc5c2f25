#include <algorithm>
#include <cmath>

#include "core/foundations/base/contract.h"
#include "core/presentation/meshfile/assembly.h"

namespace geargraph {
namespace {

/// Largest stretch of the pitch, which is a circle of length 1, without a frame.
double largestGap(double pitches, std::size_t count) {
  std::vector<double> seen;
  for (std::size_t i = 0; i < count; ++i) {
    const double position = pitches * static_cast<double>(i) / static_cast<double>(count - 1);
    seen.push_back(position - std::floor(position));
  }
  std::sort(seen.begin(), seen.end());
  double gap = seen.front() + 1 - seen.back();
  for (std::size_t i = 1; i < seen.size(); ++i) gap = std::max(gap, seen[i] - seen[i - 1]);
  return gap;
}

}  // namespace

std::vector<double> frameTimes(std::span<const double> pitches, std::size_t count) {
  GEARGRAPH_REQUIRE(count >= 2);
  // Meshes so slow beside the fastest, or at all, that their time for a pitch has no digits left for others
  // count as standing still.
  constexpr double kSlowest = 1e-12;
  constexpr double kLeast = 1e-300;
  double fastest = 0;
  for (const double rate : pitches) fastest = std::max(fastest, std::abs(rate));
  std::vector<double> moving;
  for (const double rate : pitches) {
    if (std::abs(rate) > std::max(kSlowest * fastest, kLeast)) moving.push_back(std::abs(rate));
  }
  double end = 1;
  if (!moving.empty()) {
    constexpr int kCandidates = 64;
    constexpr double kMoreThanAPitch = 1.02;
    const double shortest = kMoreThanAPitch / *std::min_element(moving.begin(), moving.end());
    double leastWorst = 2;
    for (int i = 0; i < kCandidates; ++i) {
      const double candidate = shortest * (1 + 0.5 * i / kCandidates);
      double worst = 0;
      for (const double rate : moving) worst = std::max(worst, largestGap(rate * candidate, count));
      if (worst < leastWorst - 1e-12) {
        leastWorst = worst;
        end = candidate;
      }
    }
  }
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i) {
    times.push_back(end * static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return times;
}

}  // namespace geargraph
