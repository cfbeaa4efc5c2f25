#pragma once

#include "core/presentation/exporters/exporter.h"

namespace geargraph {

// The families of exporters (exporters.h), each in a file of its own.

[[nodiscard]] ExportFamily matrixFamily();
[[nodiscard]] ExportFamily derivationFamily();
[[nodiscard]] ExportFamily handoutFamily();
[[nodiscard]] ExportFamily drawingFamily();
[[nodiscard]] ExportFamily pictureFamily();
[[nodiscard]] ExportFamily animationFamily();
[[nodiscard]] ExportFamily seenSolidFamily();
[[nodiscard]] ExportFamily solidFamily();
[[nodiscard]] ExportFamily cadFamily();
[[nodiscard]] ExportFamily profileFamily();
[[nodiscard]] ExportFamily assemblyFamily();
[[nodiscard]] ExportFamily kitFamily();
[[nodiscard]] ExportFamily simulatorFamily();
[[nodiscard]] ExportFamily jointModelFamily();
[[nodiscard]] ExportFamily controllerFamily();
[[nodiscard]] ExportFamily graphFamily();

}  // namespace geargraph
