// The worked derivation, both methods, as a document.

#include <array>

#include "core/presentation/exporters/derivation_export.h"
#include "core/presentation/exporters/export_families.h"
#include "core/presentation/exporters/input_options.h"
#include "core/presentation/page_layout/report_pdf.h"
#include "core/presentation/report/report.h"

namespace geargraph {
namespace {

template <ReportForm form>
ExportResult writeReport(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                         const std::stop_token& stop) {
  return writeDerivation(context, given, target, stop,
                         [&](const SnapshotPtr& snapshot) -> Expected<std::string> {
                           return reportText(derivationReport(snapshot, stop), form,
                                             [&] { return reportLists(*snapshot, stop); });
                         });
}

ExportResult writeReportPages(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                              const std::stop_token& stop) {
  return writeDerivation(context, given, target, stop, [&](const SnapshotPtr& snapshot) {
    return reportPdf(derivationReport(snapshot, stop), reportLists(*snapshot, stop));
  });
}

constexpr std::array kDerivationOptions = {textOption("--inputs"), textOption("--speed")};
constexpr std::array kDerivationRefusals = {&kTooLargeRefusal};
constexpr std::string_view kDerivation = toTranslate("the worked derivation");

using WriteExport = decltype(Exporter::write);

constexpr Exporter derivationExporter(std::string_view form, std::string_view title, std::string_view suffix,
                                      WriteExport write) {
  return {form,
          form,
          title,
          kDerivation,
          ExportFiles::file,
          suffix,
          kDerivationOptions,
          {},
          ExportNeed::nothing,
          kDerivationRefusals,
          write};
}

constexpr std::array kDerivationExporters = {
    derivationExporter("html", toTranslate("Web page"), "html", writeReport<ReportForm::html>),
    derivationExporter("latex", "LaTeX", "tex", writeReport<ReportForm::latex>),
    derivationExporter("md", "Markdown", "md", writeReport<ReportForm::markdown>),
    derivationExporter("pdf", "PDF", "pdf", writeReportPages)};

}  // namespace

ExportFamily derivationFamily() {
  return {toTranslate("Derivations"), toTranslate("derivations"), {},  false,
          kDerivationExporters,       ExportPurpose::print,       "md"};
}

ExportResult writeDerivation(ExportContext& context, const OptionValues& given, const ExportTarget& target,
                             const std::stop_token& stop,
                             const std::function<Expected<std::string>(const SnapshotPtr&)>& bytesOf) {
  auto document = context.engaged(given);
  if (auto* error = std::get_if<ExportError>(&document)) return std::move(*error);
  auto driven = withInputOptions(std::get<Mechanism>(std::move(document)), given);
  if (auto* error = std::get_if<UsageError>(&driven))
    return ExportError{ExportError::Kind::usage, std::move(error->message)};
  if (std::get<Mechanism>(driven).n() > kMaxReportLinks) {
    return ExportError{
        ExportError::Kind::limit,
        translated("A derivation of more than %1 links is not written: it would be too long to read. The "
                   "matrices are exported as CSV.",
                   {std::to_string(kMaxReportLinks)}),
        kTooLargeRefusal.code};
  }
  const auto analyzed = context.complete(std::get<Mechanism>(std::move(driven)), stop);
  if (const auto* error = std::get_if<ExportError>(&analyzed)) return *error;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  const Expected<std::string> bytes = bytesOf(snapshot);
  if (stop.stop_requested()) return outOfTime(translated("the derivation"));
  if (!bytes)
    return ExportError{ExportError::Kind::limit, bytes.error().front().message, kTooLargeRefusal.code};
  if (auto error = writeExport(*bytes, target.path)) return *std::move(error);
  return ExportOutcome{hasErrors(snapshot->diagnostics)};
}

}  // namespace geargraph
