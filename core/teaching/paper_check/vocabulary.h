#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/foundations/exact/rational_function.h"
#include "core/teaching/exercises/exercise_source.h"

namespace geargraph::inline paper_check {

/// A name as it is written, without its notation: \omega_{51}'', ω₅₁'' and w51'' are {"w", "51", 2}.
struct WrittenName {
  std::string base;       ///< i n N d theta w
  std::string subscript;  ///< digits, two numbers parted by '_'
  int primes = 0;
};

/// A sum of rates of joints, by joint: what the name of a velocity stands for.
using RateSum = std::map<int, int>;

/// A number that a name stands for.
struct NamedValue {
  RationalFunction value;
  bool isRatio = false;  ///< true: a ratio of teeth, kept as a symbol; false: a number of this mechanism
};

/// What the symbols of a paper mean for one mechanism: i15 = N_tail / N_head, n41 and n14 (by the links),
/// N4 teeth and d4 pitch diameter of link 4 (N7' and N7'' of its meshes in their order), θ8 the rate of
/// joint 8, ω40 the velocity of link 4 relative to link 0, ω4 the same to the ground. An immutable value.
class Vocabulary {
 public:
  explicit Vocabulary(const ExerciseSource& source);

  [[nodiscard]] const RatioRingPtr& ring() const { return m_ring; }
  [[nodiscard]] const ExerciseSource& source() const { return m_source; }
  /// Empty where the mechanism has no such number; `fault` then says why.
  [[nodiscard]] std::optional<NamedValue> value(const WrittenName& name, std::string& fault) const;
  /// Empty where it is no velocity, or one that is no sum of rates: about several directions.
  [[nodiscard]] std::optional<RateSum> rate(const WrittenName& name, std::string& fault) const;
  [[nodiscard]] static bool isRate(const WrittenName& name) {
    return name.base == "theta" || name.base == "w";
  }

  /// Is every mesh independent? Where one is redundant its ratio follows from others, and a formula may be
  /// written in several ways.
  [[nodiscard]] bool ratiosAreFree() const;

  /// The number as a function that is the same for all ratios.
  [[nodiscard]] RationalFunction constant(const Rational& value) const;
  [[nodiscard]] Rational atTeeth(const RationalFunction& value) const;

 private:
  [[nodiscard]] std::optional<NamedValue> wheel(const WrittenName& name, std::string& fault) const;
  [[nodiscard]] std::optional<std::pair<int, int>> linksOf(const std::string& subscript) const;
  [[nodiscard]] std::optional<RateSum> between(int from, int to, std::string& fault) const;

  const ExerciseSource& m_source;
  RatioRingPtr m_ring;
  std::map<std::string, std::pair<int, bool>> m_ratios;  ///< "n14" -> its mesh, and whether it is inverse
};

}  // namespace geargraph::inline paper_check
