#pragma once

#include <functional>
#include <string>

#include "core/foundations/base/expected.h"
#include "core/presentation/export_api/report_lists.h"
#include "core/presentation/exporters/export_context.h"
#include "core/presentation/report/report.h"

namespace geargraph {

/// Writes what `bytesOf` makes of the analysed document, with the inputs that the options name.
[[nodiscard]] ExportResult writeDerivation(
    ExportContext& context, const OptionValues& given, const ExportTarget& target,
    const std::stop_token& stop, const std::function<Expected<std::string>(const SnapshotPtr&)>& bytesOf);

}  // namespace geargraph
