#pragma once

#include <optional>
#include <string>

#include "core/mechanism/document_format/mechanism_graph.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The T-T graph [AU, Fig. 5]: the turning joints with their levels, and two chords for each mesh, from the
/// carrier to either gear. std::nullopt if a mesh has no carrier, or there is no spanning tree. The digraph
/// is exported by digraphFile() of graph_format.
[[nodiscard]] std::optional<std::string> ttGraphFile(const AnalysisSnapshot& snapshot, GraphForm form);

}  // namespace geargraph
