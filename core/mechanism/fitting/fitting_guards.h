#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::inline fitting {

/// Has the document a geometry to keep, and not too much of it to follow at once?
[[nodiscard]] bool canBeFitted(const Placement& placement);

/// The edited document, unless the edit broke a geometry that was sound, or gave a pinned mesh another
/// module. `placement` is that of `before`.
[[nodiscard]] Expected<Mechanism> unlessBroken(const Mechanism& before, const Placement& placement,
                                               Expected<Mechanism> edited);

}  // namespace geargraph::inline fitting
