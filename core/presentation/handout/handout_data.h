#pragma once

#include <stop_token>
#include <string>

#include "core/presentation/handout/handout_levers.h"
#include "core/presentation/scene3d/stage.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The data of the page's script, as JSON: "texts", the script's own by name (script_texts.h), and the
/// "decimal" sign; "elements" with labels, names, alone and as a "mention" in a sentence, and sentences,
/// meshes with the "walk" of their cycle, [edge, sign, sentence] from the mesh itself back to its tail;
/// "joints"; "rows", the rows of P over the joints, each divided by the radius of its head's gear, and those
/// of engaged couplings, in fractions; "inputs", positions of joints, and their "speeds". Rows and inputs are
/// empty where the mechanism has no solution. "states": the name of each state that can run, with its rows of
/// couplings, inputs and speeds; "meshRows", how many of the rows are those of meshes. With a stage "movers",
/// the links with the lines that they turn about, limits of joints, and "scene", what is shown of the train.
/// "levers" and "nomogram": writeHandoutLevers(). Every "<" is escaped, so that the text is safe in a script
/// element. Cost: that of an analysis for each state.
[[nodiscard]] std::string handoutData(const AnalysisSnapshot& snapshot, const MechanismScene* stage,
                                      double tolerance, const HandoutLevers& levers,
                                      const std::stop_token& stop);

}  // namespace geargraph
