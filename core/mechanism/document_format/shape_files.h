#pragma once

#include <filesystem>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// missing-file: one diagnostic for each 3D file of a link that is not in the document's folder or cannot be
/// opened. What is in the files is not looked at. Cost: opens each file once.
[[nodiscard]] Diagnostics missingFileDiagnostics(const Mechanism& mechanism,
                                                 const std::filesystem::path& folder);

}  // namespace geargraph
