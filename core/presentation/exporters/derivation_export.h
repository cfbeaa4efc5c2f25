#pragma once

#include <functional>
#include <string>

#include "core/foundations/base/expected.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/exporters/export_context.h"
#include "core/presentation/report/report.h"
#include "core/presentation/results/named_drawings.h"

namespace geargraph::inline exporters {

/// A drawing by its name. @pre there is one
[[nodiscard]] DisplayList drawingFor(std::string_view name, const AnalysisSnapshot& snapshot,
                                     const std::stop_token& stop);
/// The drawings of a derivation.
[[nodiscard]] ReportDrawings reportDrawings(const AnalysisSnapshot& snapshot, const std::stop_token& stop);

/// Writes what `bytesOf` makes of the analysed document, with the inputs that the options name.
[[nodiscard]] ExportResult writeDerivation(
    ExportContext& context, const OptionValues& given, const ExportTarget& target,
    const std::stop_token& stop, const std::function<Expected<std::string>(const SnapshotPtr&)>& bytesOf);

}  // namespace geargraph::inline exporters
