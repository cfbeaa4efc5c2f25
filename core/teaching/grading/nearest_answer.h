#pragma once

#include <vector>

#include "core/teaching/grading/read_answer.h"

namespace geargraph {

/// An answer, cell by cell, against the accepted one that most of its cells agree with.
struct CellMarks {
  std::vector<int> wrong;  ///< fields that differ, ascending; only where it is known which of them do
  int right = 0;           ///< cells that earn points
  int counted = 0;         ///< cells that could; the zeros of a table count only where they are missed
};

/// Of the conditions of the key: `values` and `multiple` tell cells apart, the others hold or not for all of
/// their fields. Cost: that of the conditions.
[[nodiscard]] CellMarks compareCells(const Question& question, const ReadAnswer& answer);

}  // namespace geargraph
