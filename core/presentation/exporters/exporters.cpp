#include "core/presentation/exporters/exporters.h"

#include <algorithm>
#include <array>

#include "core/foundations/base/contract.h"
#include "core/presentation/exporters/export_families.h"

namespace geargraph {
namespace {

template <class Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool takes(const Exporter& exporter, std::string_view option) {
  const auto isIt = [&](const ExportOption& each) { return each.name == option; };
  const auto isImplied = [&](const auto& each) { return each.first == option; };
  return std::any_of(exporter.options.begin(), exporter.options.end(), isIt) ||
         std::any_of(exporter.implied.begin(), exporter.implied.end(), isImplied) ||
         (option == "--force" && exporter.files == ExportFiles::folder);
}

bool takes(const ExportFamily& family, std::string_view option) {
  return std::any_of(family.exporters.begin(), family.exporters.end(),
                     [&](const Exporter& exporter) { return takes(exporter, option); });
}

bool isOfAll(std::string_view option) {
  constexpr std::array<std::string_view, 4> kOfAll = {"--to", "-o", "--state", "--engage"};
  return contains(kOfAll, option);
}

std::string howOf(const ExportFamily& family) {
  if (!family.how.empty()) return std::string(family.how);
  std::string forms;
  for (const Exporter& exporter : family.exporters) {
    if (exporter.implied.empty()) forms += (forms.empty() ? "" : ", ") + std::string(exporter.form);
  }
  return "--to " + forms;
}

bool isGiven(const OptionValues& given, std::string_view option) {
  const auto value = given.value(option);
  return value && !value->empty();
}

/// How much the options ask for this exporter of their form; std::nullopt if they ask for another.
std::optional<int> fitOf(const Exporter& exporter, const OptionValues& given) {
  int fit = 0;
  for (const auto& [name, value] : exporter.implied) {
    if (!given.has(name) || (!value.empty() && given.value(name) != value)) return std::nullopt;
    fit += 2;
  }
  for (const ExportOption& option : exporter.options) {
    if (!option.isNeeded) continue;
    if (!isGiven(given, option.name)) return std::nullopt;
    ++fit;
  }
  return fit;
}

}  // namespace

std::span<const ExportFamily> exportFamilies() {
  static const std::array kFamilies = {
      matrixFamily(),    derivationFamily(), handoutFamily(),   drawingFamily(),
      pictureFamily(),   animationFamily(),  seenSolidFamily(), solidFamily(),
      cadFamily(),       profileFamily(),    assemblyFamily(),  kitFamily(),
      simulatorFamily(), jointModelFamily(), graphFamily(),     controllerFamily()};
  return kFamilies;
}

std::span<const Exporter* const> allExporters() {
  static const std::vector<const Exporter*> kExporters = [] {
    std::vector<const Exporter*> all;
    for (const ExportFamily& family : exportFamilies()) {
      for (const Exporter& exporter : family.exporters) all.push_back(&exporter);
    }
    return all;
  }();
  return kExporters;
}

const Exporter* exporterWithId(std::string_view id) {
  for (const Exporter* exporter : allExporters()) {
    if (exporter->id == id) return exporter;
  }
  return nullptr;
}

const ExportFamily& familyOf(const Exporter& exporter) {
  const auto families = exportFamilies();
  const auto found = std::find_if(families.begin(), families.end(), [&](const ExportFamily& family) {
    return std::any_of(family.exporters.begin(), family.exporters.end(),
                       [&](const Exporter& each) { return &each == &exporter; });
  });
  GEARGRAPH_REQUIRE(found != families.end());
  return *found;
}

std::vector<std::string> exportForms() {
  std::vector<std::string> forms;
  for (const Exporter* exporter : allExporters()) {
    if (exporter->implied.empty() && !contains(forms, exporter->form)) forms.emplace_back(exporter->form);
  }
  return forms;
}

const Exporter* exporterOf(std::string_view form, const OptionValues& given) {
  const Exporter* chosen = nullptr;
  int best = -1;
  for (const Exporter* exporter : allExporters()) {
    if (exporter->form != form) continue;
    const std::optional<int> fit = fitOf(*exporter, given);
    if (!fit || *fit <= best) continue;
    chosen = exporter;
    best = *fit;
  }
  if (chosen != nullptr) return chosen;
  for (const Exporter* exporter : allExporters()) {
    if (exporter->form == form && exporter->implied.empty()) return exporter;
  }
  return nullptr;
}

OptionValues withImplied(const Exporter& exporter, OptionValues given) {
  for (const auto& [name, value] : exporter.implied)
    given.options[std::string(name)] = {value.empty() ? "true" : std::string(value)};
  return given;
}

OptionValues optionsFor(const Exporter& exporter, const OptionValues& given) {
  OptionValues taken;
  for (const auto& [name, values] : given.options) {
    if (takes(exporter, name) || isOfAll(name)) taken.options[name] = values;
  }
  return withImplied(exporter, std::move(taken));
}

std::string exportPurposeTitle(ExportPurpose purpose) {
  constexpr std::array<std::string_view, kExportPurposes.size()> kTitles = {
      toTranslate("Print and text"), toTranslate("CAD and making"), toTranslate("Simulators and control"),
      toTranslate("Web and class"), toTranslate("Data and graphs")};
  return translated(kTitles.at(static_cast<std::size_t>(purpose)));
}

std::string wordsFor(const Exporter& exporter, const OptionValues& given) {
  const std::string to = "--to " + std::string(exporter.form);
  const bool isViewed = familyOf(exporter).hasView && isGiven(given, "--view");
  return isViewed ? to + " --view " + *given.value("--view") : to;
}

std::optional<UsageError> uselessOption(const Exporter& exporter, const OptionValues& given) {
  const ExportFamily& family = familyOf(exporter);
  for (const OptionText& option : exportOptionTexts()) {
    if (!given.has(option.name) || isOfAll(option.name) || takes(family, option.name)) continue;
    std::string others;
    for (const ExportFamily& each : exportFamilies()) {
      if (!takes(each, option.name)) continue;
      const std::string how = howOf(each);
      others +=
          (others.empty() ? "" : "; ") + (each.name.empty() ? how : translated(each.name) + " (" + how + ')');
    }
    return UsageError{translated("%1 has no meaning with %2; it is an option of %3.",
                                 {option.name, wordsFor(exporter, given), others})};
  }
  return std::nullopt;
}

const OptionText& exportOptionText(std::string_view name) {
  const auto texts = exportOptionTexts();
  const auto found =
      std::find_if(texts.begin(), texts.end(), [&](const OptionText& text) { return text.name == name; });
  GEARGRAPH_REQUIRE(found != texts.end());
  return *found;
}

std::string unmetNeed(const Exporter& exporter, const AnalysisSnapshot& live) {
  if (std::string why = exporter.missing != nullptr ? exporter.missing() : std::string(); !why.empty())
    return why;
  if (!exporter.knowsSlides && hasSlides(*live.mechanism)) return translated(kSlidesRefusal.meaning);
  if (exporter.need == ExportNeed::nothing) return {};
  if (!live.tree) return translated("The turning joints are no spanning tree.");
  if (exporter.need == ExportNeed::tree) return {};
  if (hasErrors(live.diagnostics) || live.matroid() == nullptr)
    return translated("The mechanism has errors.");
  if (exporter.need == ExportNeed::kinematics || live.matroid()->solution) return {};
  return translated("There is no solution, because nothing can move or inputs are missing.");
}

ExportResult writeExport(const Exporter& exporter, ExportContext& context, const OptionValues& given,
                         const ExportTarget& target, const std::stop_token& stop) {
  if (!exporter.knowsSlides) {
    const auto document = context.document();
    if (const auto* error = std::get_if<ExportError>(&document)) return *error;
    if (hasSlides(*std::get<MechanismPtr>(document)))
      return ExportError{ExportError::Kind::mechanism, translated(kSlidesRefusal.meaning),
                         kSlidesRefusal.code};
  }
  return exporter.write(context, given, target, stop);
}

}  // namespace geargraph
