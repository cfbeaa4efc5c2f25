#pragma once

#include <utility>

#include "core/exact/fields.h"
#include "core/ttgraph/tt_graph.h"

namespace geargraph {

/// The factors of Eq. (26) in the ratio of the mesh, the variable of its number: i w_ik - s w_jk = 0.
struct RatioWeights {
  const RationalFunctionField* field;
  [[nodiscard]] std::pair<RationalFunction, RationalFunction> operator()(const TerminalPair& pair) const {
    return {RationalFunction::variable(field->ring(), pair.mesh), field->fromInteger(-pair.sign)};
  }
};

}  // namespace geargraph
