#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/foundations/base/rational.h"

namespace geargraph {

/// A number as a controller's file writes it. A decimal may be rounded: it stands for what is within half a
/// unit of its last digit (of digits below 1e-15 of it, for printed doubles); a fraction or a whole number
/// for itself.
struct CouplingNumber {
  Rational value;
  Rational tolerance;
  std::string text;

  [[nodiscard]] bool standsFor(const Rational& exact) const { return (value - exact).abs() <= tolerance; }
};

/// std::nullopt for what is no number.
[[nodiscard]] std::optional<CouplingNumber> writtenNumber(std::string_view text);

enum class CouplingMatrix { motorToJoint, jointToMotor };

/// The matrices of a controller, row by row, with the offsets of angles: joints = A motors + jointOffsets.
struct WrittenCoupling {
  int size = 0;
  std::optional<std::vector<CouplingNumber>> motorToJoint;
  std::optional<std::vector<CouplingNumber>> jointToMotor;
  std::optional<std::vector<CouplingNumber>> jointOffsets;
  std::optional<std::vector<CouplingNumber>> motorOffsets;

  [[nodiscard]] const std::optional<std::vector<CouplingNumber>>& of(CouplingMatrix which) const {
    return which == CouplingMatrix::motorToJoint ? motorToJoint : jointToMotor;
  }
};

/// The most rows of a matrix.
constexpr int kMaxWrittenRows = 100;

/// Is this a JSON object with `motorToJoint` or `jointToMotor`?
[[nodiscard]] bool isWrittenCoupling(std::string_view text);

/// Reads JSON with the members `motorToJoint`, `jointToMotor` (arrays of rows), `jointOffsets` and
/// `motorOffsets` (arrays), as `export --to coupling` writes them, numbers as numbers or texts ("-1/2"); or,
/// of the matrix `alone`, an array of rows, or lines with commas, semicolons, tabs or blanks between the
/// numbers. Errors: syntax, and schema with the line for rows of different lengths, a matrix that is not
/// square, sizes that differ, what is no number.
[[nodiscard]] Expected<WrittenCoupling> readWrittenCoupling(std::string_view text,
                                                            std::optional<CouplingMatrix> alone);

}  // namespace geargraph
