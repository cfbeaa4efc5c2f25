#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "core/foundations/base/expected.h"
#include "core/presentation/handout/handout_exercises.h"
#include "core/presentation/report/report.h"
#include "core/presentation/scene3d/stage.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The largest size of a page in bytes, for learning platforms and e-mail.
constexpr std::size_t kMaxHandoutBytes = 3'000'000;

/// The train in three dimensions.
struct HandoutTrain {
  MechanismScenePtr stage;  ///< null, or without instances: the page has no such part
  std::string still;        ///< the bytes of a PNG, shown where scripts do not run; may be empty
};

/// Where a page is shown: by itself, or in a learning platform, to which it reports what was viewed (SCORM
/// 1.2).
enum class HandoutUse { alone, learningPlatform };

/// A mechanism as one HTML file that any browser shows offline: drawings, matrices, the solution and the
/// derivation, complete without scripts. Its scripts link them (a click on an element highlights it
/// everywhere), drive the inputs, in fractions, by elimination on the rows of P, and turn the train in 3D. A
/// Content-Security-Policy in the page forbids everything else.
///
/// Texts and the decimal sign are those of the current language, also those of the script, which the page's
/// data hold.
///
/// With exercises the page asks the questions, grades them by the same data as the program, with the location
/// and reason of mistakes, and saves files of answers that the program can grade.
///
/// `drawings`: those that a document arranges, in SVG, whose elements have the attributes data-list and
/// data-id; levers and nomogram are drawn by the page. Coarser solids are used where the page would be too
/// large, and the page notes it; beyond kMaxHandoutBytes it fails with `graphics` and the name of the largest
/// part. The result is meaningless if `stop` was requested meanwhile. Cost: that of the derivation, and of
/// finer solids.
/// @pre the snapshot is complete (analyze()); no more than kMaxReportLinks links
[[nodiscard]] Expected<std::string> handoutHtml(const SnapshotPtr& snapshot, const ReportDrawings& drawings,
                                                const HandoutTrain& train = {},
                                                HandoutUse use = HandoutUse::alone,
                                                const std::optional<HandoutExercises>& exercises = {},
                                                const std::stop_token& stop = {});

}  // namespace geargraph
