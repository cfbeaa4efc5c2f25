#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "core/foundations/base/expected.h"
#include "core/presentation/handout/handout_exercises.h"
#include "core/presentation/report/report.h"
#include "core/presentation/stage/stage.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::inline handout {

/// Bytes that a page may have: what a learning platform or a mail takes.
constexpr std::size_t kMostHandoutBytes = 3'000'000;

/// The train in three dimensions.
struct HandoutTrain {
  StagePtr stage;     ///< null, or without instances: the page has no such part
  std::string still;  ///< the bytes of a PNG, which stands where scripts do not run; may be empty
};

/// Where a page is shown: by itself, or by a learning platform, which it tells what was seen (SCORM 1.2).
enum class HandoutUse { alone, learningPlatform };

/// A mechanism as one HTML file that any browser shows without a network: drawings, matrices, the solution
/// and the derivation, complete before any script runs. Its scripts link them (a click on an element lights
/// it everywhere), drive the inputs, in fractions, by elimination on the rows of P, and turn the train in
/// three dimensions. A policy in the page forbids everything else.
///
/// With exercises the page asks them, grades by the same data as the program, with places and reasons, and
/// writes files of answers that the program grades.
///
/// `drawings`: those that are shown, in SVG; their elements carry data-list and data-id.
/// Solids are taken coarser where the page would be too large, and the page says so; one beyond
/// kMostHandoutBytes fails (graphics), with the name of its largest part.
/// Of no use when `stop` was requested meanwhile. Cost: that of the derivation, and of finer solids.
/// @pre the snapshot is complete (analyze()); no more than kMostReportLinks links
[[nodiscard]] Expected<std::string> handoutHtml(const SnapshotPtr& snapshot, const ReportDrawings& drawings,
                                                const HandoutTrain& train = {},
                                                HandoutUse use = HandoutUse::alone,
                                                const std::optional<HandoutExercises>& exercises = {},
                                                const std::stop_token& stop = {});

}  // namespace geargraph::inline handout
