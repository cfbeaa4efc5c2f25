#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/presentation/exporters/export_context.h"
#include "core/presentation/exporters/exporter.h"

namespace geargraph {

/// Every family of exporters, in the order of the help.
[[nodiscard]] std::span<const ExportFamily> exportFamilies();
/// Every exporter, family by family.
[[nodiscard]] std::span<const Exporter* const> allExporters();
/// Null if there is none.
[[nodiscard]] const Exporter* exporterWithId(std::string_view id);
[[nodiscard]] const ExportFamily& familyOf(const Exporter& exporter);

/// The words that `--to` takes, each once.
[[nodiscard]] std::vector<std::string> exportForms();
/// The exporter of a form that the options choose: the one with the most implied and needed options among
/// them; without any, the first that implies none. Null if there is no such form.
[[nodiscard]] const Exporter* exporterOf(std::string_view form, const OptionValues& given);
/// The options with those that choose this exporter.
[[nodiscard]] OptionValues withImplied(const Exporter& exporter, OptionValues given);
/// The words that ask for an exporter with these options: "--to svg --view digraph".
[[nodiscard]] std::string wordsFor(const Exporter& exporter, const OptionValues& given);
/// The first option that means nothing to the family of the exporter, as a sentence that says what it is for.
[[nodiscard]] std::optional<UsageError> uselessOption(const Exporter& exporter, const OptionValues& given);

/// What people export for, as a dialog calls it, translated.
[[nodiscard]] std::string exportPurposeTitle(ExportPurpose purpose);
/// Those of the options that another exporter takes too, with the ones that choose it.
[[nodiscard]] OptionValues optionsFor(const Exporter& exporter, const OptionValues& given);

/// Every option of `geargraph-cli export`, in the order of the help; `--to`, `-o`, `--state` and `--engage`
/// are options of all exporters.
[[nodiscard]] std::span<const OptionText> exportOptionTexts();
/// The text of an option. @pre it is in the table
[[nodiscard]] const OptionText& exportOptionText(std::string_view name);
/// What a dialog calls an option, translated. @pre an exporter lists it
[[nodiscard]] std::string exportOptionTitle(std::string_view name);
/// What a dialog calls one of the choices of an option, translated: "Semicolon"; "" where it has no other
/// name than its word. The words themselves are those of the command line, in every language.
[[nodiscard]] std::string exportChoiceTitle(std::string_view option, std::string_view choice);

/// Why an exporter cannot write anything here, or has nothing to write of a mechanism by its live analysis,
/// as a sentence; empty if ExportNeed is met. Cheap.
[[nodiscard]] std::string unmetNeed(const Exporter& exporter, const AnalysisSnapshot& live);

/// Exporter::write(), which everything that exports calls through this: an exporter that does not know
/// sliding joints writes nothing of a document that has some.
[[nodiscard]] ExportResult writeExport(const Exporter& exporter, ExportContext& context,
                                       const OptionValues& given, const ExportTarget& target,
                                       const std::stop_token& stop);

}  // namespace geargraph
