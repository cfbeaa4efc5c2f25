#pragma once

#include <functional>
#include <string>
#include <variant>

#include "core/presentation/brep/brep.h"

namespace geargraph {

/// What became of an assembly.
struct StepFile {
  std::string bytes;
  int solids = 0;    ///< in all parts
  int ununited = 0;  ///< parts whose solids could not be united
};

/// The assembly as a STEP file (AP214): a product for every part and node, with names and colours. Every
/// shape is checked; the name of the first that is not valid is returned instead. `progress`: the fraction
/// done.
[[nodiscard]] std::variant<StepFile, std::string> stepFile(const CadAssembly& assembly,
                                                           const std::function<void(double)>& progress);

}  // namespace geargraph
