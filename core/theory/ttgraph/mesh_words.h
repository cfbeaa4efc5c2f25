#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/theory/ttgraph/tt_graph.h"

namespace geargraph {

/// One mesh of the T-T graph in the paper's notation, with printed subscripts, primes and minus signs.
struct MeshWords {
  std::string set;       ///< "(5,2)(1)": the gear pair and its carrier arm
  std::string path;      ///< "5 –b– 0 –b– 1 –c– 2"
  std::string terminal;  ///< "ω₅₁′′ = −n₂₅ ω₂₁′′"; empty where the sign is not known
  std::string tailCircuit;  ///< "ω₅₁′′ = ω₅₀ − ω₁₀"; empty until every mesh has its terminal equation
  std::string headCircuit;  ///< "ω₂₁′′ = ω₂₁"
  // The numbers of these equations (EquationNumbers); 0 where they are empty.
  int terminalNumber = 0;
  int tailNumber = 0;
  int headNumber = 0;
};

/// std::nullopt if the mesh has no transfer vertex. Cost: the length of its walk.
[[nodiscard]] std::optional<MeshWords> meshWords(const TtGraph& graph, MeshOrdinal mesh);

/// A formula of TtEquations or VelocityName in text style, typeset with Unicode: "w51'' = -n25 w21''" becomes
/// "ω₅₁′′ = −n₂₅ ω₂₁′′".
[[nodiscard]] std::string inPrint(std::string_view formula);

}  // namespace geargraph
