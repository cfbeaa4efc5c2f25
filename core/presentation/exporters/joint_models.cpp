// The mechanism as equations between the angles of its joints.

#include <array>

#include "core/presentation/exporters/export_context.h"
#include "core/presentation/exporters/export_families.h"
#include "core/presentation/simulators/modelica.h"

namespace geargraph {
namespace {

ExportResult writeModelica(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                           const std::stop_token& stop) {
  const auto analyzed = context.live(given, stop);
  if (const auto* error = std::get_if<ExportError>(&analyzed)) return *error;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  if (hasErrors(snapshot->diagnostics) || snapshot->matroid() == nullptr)
    return ExportError{ExportError::Kind::mechanism, {}, kErrorsRefusal.code};
  if (auto error = writeExport(modelicaText(*snapshot), target.path)) return *std::move(error);
  return ExportOutcome{};
}

constexpr std::array kModelicaRefusals = {&kErrorsRefusal};
constexpr std::array kJointModelExporters = {Exporter{"modelica",
                                                      "modelica",
                                                      "Modelica",
                                                      toTranslate("a model of the joints"),
                                                      ExportFiles::file,
                                                      "mo",
                                                      {},
                                                      {},
                                                      ExportNeed::kinematics,
                                                      kModelicaRefusals,
                                                      writeModelica}};

}  // namespace

ExportFamily jointModelFamily() {
  return {toTranslate("Models of the joints"), {}, {}, false, kJointModelExporters, ExportPurpose::simulator};
}

}  // namespace geargraph
