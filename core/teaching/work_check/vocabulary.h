#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/foundations/exact/rational_function.h"
#include "core/teaching/exercises/exercise_source.h"
#include "core/teaching/grading/written_name.h"

namespace geargraph {

/// A velocity as a sum of rates of joints: coefficient by joint.
using RateSum = std::map<int, int>;

/// The value of a name.
struct NamedValue {
  RationalFunction value;
  bool isRatio = false;  ///< true: a ratio of teeth, treated as a symbol; false: a number of this mechanism
};

/// The meaning of the symbols for one mechanism: i15 = N_tail / N_head, n41 and n14 (by the links), N4 teeth
/// and d4 pitch diameter of link 4 (N7' and N7'' of its meshes in their order), θ8 the rate of joint 8, ω40
/// the velocity of link 4 relative to link 0, ω4 the same to the ground. An immutable value.
class Vocabulary {
 public:
  explicit Vocabulary(const ExerciseSource& source);

  [[nodiscard]] const RatioRingPtr& ring() const { return m_ring; }
  [[nodiscard]] const ExerciseSource& source() const { return m_source; }
  /// std::nullopt, with the reason in `fault`, if the mechanism has no such number.
  [[nodiscard]] std::optional<NamedValue> value(const WrittenName& name, std::string& fault) const;
  /// std::nullopt, with the reason in `fault`, if it is no velocity, or no sum of rates: about several
  /// directions.
  [[nodiscard]] std::optional<RateSum> rate(const WrittenName& name, std::string& fault) const;
  [[nodiscard]] static bool isRate(const WrittenName& name) {
    return name.base == "theta" || name.base == "w";
  }

  /// Is every mesh independent? The ratio of a redundant one follows from others, so that a formula can have
  /// several forms.
  [[nodiscard]] bool ratiosAreFree() const;

  /// The number as a constant function of the ratios.
  [[nodiscard]] RationalFunction constant(const Rational& value) const;
  /// The value of a function at the mechanism's own ratios.
  [[nodiscard]] Rational atTeeth(const RationalFunction& value) const;

 private:
  [[nodiscard]] std::optional<NamedValue> wheel(const WrittenName& name, std::string& fault) const;
  [[nodiscard]] std::optional<std::pair<int, int>> linksOf(const std::string& subscript) const;
  [[nodiscard]] std::optional<RateSum> between(int from, int to, std::string& fault) const;

  const ExerciseSource& m_source;
  RatioRingPtr m_ring;
  std::map<std::string, std::pair<int, bool>> m_ratios;  ///< "n14" -> its mesh, and whether it is inverse
};

}  // namespace geargraph
