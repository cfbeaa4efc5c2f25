#pragma once

#include <stop_token>
#include <string>

#include "core/presentation/handout/handout_levers.h"
#include "core/presentation/report/report.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// "1 mesh", "4 meshes", in the current language: of "%1 mesh" and "%1 meshes", which toTranslate() marks.
[[nodiscard]] std::string counted(int number, const char* one, const char* several);

// The parts of a page, each the content of a section with its heading.

/// A figure for each drawing that is not empty.
[[nodiscard]] std::string drawingsSection(const ReportDrawings& drawings, const HandoutLevers& levers);
/// Tables of the matrices (1)-(5) and of P, with headings that name their elements.
[[nodiscard]] std::string matricesSection(const SnapshotPtr& snapshot);
/// The picture shown where the train cannot be shown in 3D: `still`, a PNG, in base64; or none.
[[nodiscard]] std::string trainSection(const std::string& still);
/// The outputs as fractions of the inputs, the speeds of all joints now, and the states of a gearbox. The
/// result is meaningless if `stop` was requested.
[[nodiscard]] std::string solutionSection(const AnalysisSnapshot& snapshot, const std::stop_token& stop);
/// Both methods, step by step, without the drawings.
[[nodiscard]] std::string derivationSection(const Report& report);

}  // namespace geargraph
