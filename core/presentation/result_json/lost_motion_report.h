#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/teaching/force_tables/force_table.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/lost_motion/lost_motion.h"

namespace geargraph {

/// The lost motion of a train as engaged.
struct LostMotionCase {
  std::optional<int> state;            ///< position in the document; none: as the document is engaged
  std::optional<LostMotions> motions;  ///< none where the train has no solution, or is too large
  /// How each output turns with each held input: a row an output, a column an input; empty without `motions`.
  std::vector<Rational> gains;

  /// How far input `input` turns from stop to stop where the output is held instead of it; none where the
  /// input does not move the output, or the output's is not known. Positions in the lists of `motions`.
  [[nodiscard]] std::optional<Rational> atInput(std::size_t output, std::size_t input) const;
};

/// std::nullopt if `stop` was requested. Cost: lostMotions() and an exact solution.
[[nodiscard]] std::optional<LostMotionCase> lostMotionCase(const AnalysisSnapshot& snapshot,
                                                           const std::stop_token& stop = {});
/// One for each state of the document, driven as withStateEngaged() says. std::nullopt if `stop` was
/// requested.
[[nodiscard]] std::optional<std::vector<LostMotionCase>> lostMotionCases(const Mechanism& mechanism,
                                                                         const std::stop_token& stop = {});

/// A row for each output and input, angles in minutes of arc; the worst at the output also exactly, in rad.
/// For the window and CSV.
[[nodiscard]] ValueTable lostMotionTable(const Mechanism& mechanism,
                                         const std::vector<LostMotionCase>& cases);

/// `backlash --json`. `mechanism`: null where the file could not be read.
[[nodiscard]] std::string lostMotionJson(const Mechanism* mechanism,
                                         const std::vector<LostMotionCase>& cases);

}  // namespace geargraph
