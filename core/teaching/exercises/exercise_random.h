#pragma once

#include <cstdint>
#include <vector>

namespace geargraph {

/// A seed for a new sheet, from the system's source of random numbers: below 2^31, so that it can be typed.
[[nodiscard]] std::uint64_t randomSeed();

/// The generator of exercises: splitmix64 (Steele, Lea and Flood, 2014) on 64-bit integers. It uses no
/// distribution of the standard library, so that a seed gives the same sheet on every platform.
///
///     state += 0x9E3779B97F4A7C15
///     z = (state ^ state >> 30) * 0xBF58476D1CE4E5B9
///     z = (z ^ z >> 27) * 0x94D049BB133111EB
///     next = z ^ z >> 31
class ExerciseRandom {
 public:
  explicit ExerciseRandom(std::uint64_t seed) : m_state(seed) {}
  /// The stream of one question of one variant: each of the three numbers in turn is added to the state, then
  /// one number is drawn and becomes the state.
  ExerciseRandom(std::uint64_t seed, std::uint64_t variant, std::uint64_t question);

  [[nodiscard]] std::uint64_t next();
  /// A number in 0 .. count-1, uniformly distributed: draws not below the greatest multiple of count are
  /// rejected, the others taken modulo count. @pre count > 0
  [[nodiscard]] int below(int count);
  /// One of least .. most. @pre least <= most
  [[nodiscard]] int between(int least, int most) { return least + below(most - least + 1); }
  template <class Value>
  [[nodiscard]] const Value& oneOf(const std::vector<Value>& values) {
    return values[static_cast<std::size_t>(below(static_cast<int>(values.size())))];
  }
  /// A random choice of `count` of these numbers, or all if there are fewer, in their order.
  [[nodiscard]] std::vector<int> someOf(std::vector<int> numbers, int count);

 private:
  std::uint64_t m_state;
};

}  // namespace geargraph
