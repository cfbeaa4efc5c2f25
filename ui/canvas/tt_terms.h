#pragma once

#include <QString>

namespace geargraph {

/// The words of the T-T graph.
enum class TtTerm { graph, level, transferVertex, chord, terminalEquation, fundamentalCircuit };

/// The definition of a term as a tooltip: its name in bold, the text, the paper's equation.
[[nodiscard]] QString tipOf(TtTerm term);

}  // namespace geargraph
