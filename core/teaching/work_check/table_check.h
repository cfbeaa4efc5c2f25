#pragma once

#include "core/teaching/work_check/submitted_text.h"
#include "core/teaching/work_check/table_alignment.h"
#include "core/teaching/work_check/work_check.h"

namespace geargraph {

/// checkPaper() for matrices.
[[nodiscard]] Expected<MatrixVerdict> checkTable(const ExerciseSource& source, const WrittenTable& table,
                                                 std::optional<PaperMatrix> kind,
                                                 const std::stop_token& stop);

/// Recognises C, T or Z of another spanning tree, with meshes among its edges: returns the labels of the
/// tree's edges, or std::nullopt if it is the matrix of no tree. C in the order of its labels, else in the
/// natural one; T and Z need labels.
[[nodiscard]] std::optional<std::vector<int>> otherTree(const Vocabulary& vocabulary, PaperMatrix kind,
                                                        const WrittenTable& table,
                                                        const WrittenAmounts& amounts);

/// The number in a label: 16 of "C16", "C_{16}", "mesh 16", 8 of "θ8", the joint of "ω40".
[[nodiscard]] std::optional<int> labelNumber(const Vocabulary& vocabulary, const std::string& text);

}  // namespace geargraph
