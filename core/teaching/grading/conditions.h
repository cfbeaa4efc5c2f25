#pragma once

#include <span>

#include "core/teaching/grading/read_answer.h"

namespace geargraph {

/// Does the condition hold for this answer? A condition on a field that cannot be parsed does not hold.
/// Cost: linear in the condition and the answer; `basis` and `dependent` an exact elimination, `rows` the
/// square of the rows.
/// @pre the condition belongs to the question that the answer was read by
[[nodiscard]] bool holds(const Condition& condition, const ReadAnswer& answer);

[[nodiscard]] bool allHold(std::span<const Condition> conditions, const ReadAnswer& answer);

}  // namespace geargraph
