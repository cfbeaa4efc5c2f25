#pragma once

#include <string>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// slides-not-covered: an analysis that knows turning joints only leaves out a mechanism with sliding ones.
/// `what`: that analysis, as the beginning of a sentence.
[[nodiscard]] Diagnostic slidesNotCovered(const Mechanism& mechanism, const std::string& what);

}  // namespace geargraph
