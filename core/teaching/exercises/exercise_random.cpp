#include "core/teaching/exercises/exercise_random.h"

#include <limits>
#include <random>

#include "core/foundations/base/contract.h"

namespace geargraph {

std::uint64_t randomSeed() {
  constexpr unsigned kMask = 0x7FFFFFFFU;
  return std::random_device{}() & kMask;
}

ExerciseRandom::ExerciseRandom(std::uint64_t seed, std::uint64_t variant, std::uint64_t question)
    : m_state(0) {
  for (const std::uint64_t part : {seed, variant, question}) {
    m_state += part;
    m_state = next();
  }
}

std::uint64_t ExerciseRandom::next() {
  m_state += 0x9E3779B97F4A7C15U;
  std::uint64_t z = m_state;
  z = (z ^ z >> 30U) * 0xBF58476D1CE4E5B9U;
  z = (z ^ z >> 27U) * 0x94D049BB133111EBU;
  return z ^ z >> 31U;
}

int ExerciseRandom::below(int count) {
  GEARGRAPH_REQUIRE(count > 0);
  const auto size = static_cast<std::uint64_t>(count);
  const std::uint64_t limit = std::numeric_limits<std::uint64_t>::max() / size * size;
  std::uint64_t drawn = next();
  while (drawn >= limit) drawn = next();
  return static_cast<int>(drawn % size);
}

std::vector<int> ExerciseRandom::someOf(std::vector<int> numbers, int count) {
  while (static_cast<int>(numbers.size()) > count)
    numbers.erase(numbers.begin() + below(static_cast<int>(numbers.size())));
  return numbers;
}

}  // namespace geargraph
