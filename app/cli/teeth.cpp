// `teeth FILE WISH` and `teeth --check CERTIFICATE`: whole teeth for wanted ratios, and the proof that there
// are no better ones.

#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/load.h"
#include "app/cli/text_table.h"
#include "app/cli/time_limit.h"
#include "core/design/teeth_check/teeth_check.h"
#include "core/design/teeth_search/teeth_certificate.h"
#include "core/design/teeth_search/teeth_json.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/wording.h"
#include "core/foundations/base/words.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph::cli {
namespace {

constexpr std::size_t kMostShown = 20;
constexpr std::size_t kMostChoices = 100'000;
constexpr std::size_t kLargestWish = std::size_t{1} << 20U;

/// "+0.184 %", of a relative error.
std::string percentText(const Rational& error) {
  if (error.isZero()) return translated("exact");
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%+.3g %%", 100 * error.toDouble());
  return buffer;
}

std::string shareText(const std::optional<double>& value) {
  return value ? readableNumber(*value) : "-";
}

TextRows choiceRows(const TeethAnswer& answer, const std::vector<TeethChoice>& choices) {
  const TeethProblem& problem = *answer.problem;
  const bool hasPlanets = !problem.planets.empty();
  TextRows rows{{translated("choice")}};
  for (const SearchedWheel& wheel : problem.wheels) rows[0].push_back(wheel.name);
  for (std::size_t ratio = 0; ratio < problem.ratios.size(); ++ratio) {
    rows[0].push_back(translated("ratio"));
    rows[0].push_back(translated("error"));
  }
  if (hasPlanets) rows[0].push_back(translated("planets"));
  rows[0].push_back(translated("undercut"));
  rows[0].push_back(translated("efficiency"));
  rows[0].push_back(translated("backward"));
  for (const TeethChoice& choice : choices) {
    std::vector<std::string> row{std::to_string(rows.size())};
    for (const int teeth : choice.found.teeth) row.push_back(std::to_string(teeth));
    for (std::size_t ratio = 0; ratio < problem.ratios.size(); ++ratio) {
      row.push_back(choice.found.ratios[ratio].toString());
      row.push_back(percentText(choice.found.errors[ratio]));
    }
    if (hasPlanets) {
      std::string planets;
      for (const int count : choice.planets) planets += (planets.empty() ? "" : " ") + std::to_string(count);
      row.push_back(planets.empty() ? "-" : planets);
    }
    row.push_back(choice.undercut.empty() ? "-" : listed(choice.undercut, kAllNames));
    row.push_back(shareText(choice.efficiency));
    row.push_back(shareText(choice.backward));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string filterText(const std::string& name) {
  if (name == "turns") return translated("turn");
  if (name == "clears") return translated("with planets that clear each other");
  if (name == "assembles") return translated("with equal planets that go in");
  if (name == "hunting") return translated("with hunting teeth only");
  if (name == "undercut") return translated("without undercut");
  return translated("within the bounds");
}

std::string asText(const TeethAnswer& answer) {
  const TeethFound& found = answer.found;
  std::string text = translated("All %1 choices were tried.", {std::to_string(found.counts.tried)});
  text += '\n';
  for (const auto& [name, count] : filtersOf(*answer.problem, found.counts))
    text += "  " + std::to_string(count) + ' ' + filterText(name) + '\n';
  text += "  " + std::to_string(found.counts.accepted) + ' ' + translated("meet the wish") + "\n\n";
  for (const std::string& conflict : conflictSentences(answer)) text += conflict + '\n';
  if (answer.nearest)
    return text + aligned(translated("None. The nearest"), choiceRows(answer, {*answer.nearest}));
  if (!answer.conflicts.empty()) return text;
  return text + aligned(translated("Choices, the best first"), choiceRows(answer, answer.choices));
}

std::string asText(const TeethVerdict& verdict) {
  std::string text =
      verdict.holds()
          ? translated("The certificate holds: %1 choices were tried again, %2 are within the bounds.",
                       {std::to_string(verdict.tried), std::to_string(verdict.within)})
          : translated("The certificate does not hold.");
  text += '\n';
  for (const std::string& fault : verdict.faults) text += "  " + fault + '\n';
  return text;
}

int runTeethCheck(const Arguments& arguments, const std::string& path) {
  const auto text = readFile(path, kLargestFile);
  if (const auto* error = std::get_if<FileError>(&text)) return fileFailure(error->message);
  const auto verdict = checkTeeth(std::get<std::string>(text), arguments.stop);
  if (!verdict) {
    std::cerr << diagnosticLines(path, verdict.error());
    return kUsageOrFile;
  }
  if (!verdict->isComplete && verdict->faults.empty()) return outOfTime(arguments, translated("the check"));
  const int status = verdict->holds() ? kFine : kMechanismErrors;
  return print(arguments.has("--json") ? verdictJson(*verdict) : asText(*verdict), status);
}

int runTeeth(const Arguments& arguments) {
  if (const auto certificate = arguments.value("--check")) {
    if (!arguments.files.empty() || arguments.has("--certificate") || arguments.has("--limit"))
      return wrongUsage(kTeeth,
                        translated("A certificate is checked by itself, without a mechanism and a wish."));
    return runTeethCheck(arguments, *certificate);
  }
  if (arguments.files.size() != 2)
    return wrongUsage(kTeeth, translated("A mechanism and a file with a wish are needed."));
  std::size_t most = kMostShown;
  if (const auto word = arguments.value("--limit")) {
    const auto number = numberFrom<std::size_t>(*word);
    if (!number || *number > kMostChoices)
      return wrongUsage(kTeeth,
                        translated("--limit is a whole number up to %1.", {std::to_string(kMostChoices)}));
    most = *number;
  }
  const auto loaded = loadOrSay(arguments.files.front());
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  const std::string& path = arguments.files[1];
  const auto text = readFile(path, kLargestWish);
  if (const auto* error = std::get_if<FileError>(&text)) return fileFailure(error->message);
  const std::string& wished = std::get<std::string>(text);
  const PlacedMechanism drawn = std::get<Mechanism>(loaded);
  const auto wish = readTeethWish(wished, drawn);
  if (!wish) {
    std::cerr << diagnosticLines(path, wish.error());
    return kUsageOrFile;
  }
  TeethSearchOptions options;
  options.most = most;
  const auto answer = teethFor(drawn, *wish, options, arguments.stop);
  if (!answer) {
    const bool isOfWish = answer.error().front().code == Code::schema;
    std::cerr << diagnosticLines(isOfWish ? path : arguments.files.front(), answer.error());
    return isOfWish ? kUsageOrFile : kMechanismErrors;
  }
  if (!answer->found.isComplete) return outOfTime(arguments, translated("the search"));
  if (const auto target = arguments.value("--certificate")) {
    const auto certificate = teethCertificate(*answer, wished, GEARGRAPH_VERSION);
    if (!certificate) {
      std::cerr << diagnosticLines(path, certificate.error());
      return kUsageOrFile;
    }
    if (const auto error = writeFile(*target, *certificate)) return fileFailure(error->message);
  }
  return print(arguments.has("--json") ? teethJson(*answer) : asText(*answer));
}

constexpr std::array kTeethOptions = {
    Option{"--limit", "N", toTranslate("how many choices are given, the best first (20)")},
    Option{"--certificate", "FILE", toTranslate("write what proves that all choices were tried")},
    Option{"--check", "CERTIFICATE", toTranslate("check such a proof, with code of its own")},
    Option{"--json", "", toTranslate("as JSON")},
};

}  // namespace

const Command kTeeth = {
    "teeth",
    "FILE WISH [--limit N] [--certificate FILE] [--json], or --check CERTIFICATE [--json]",
    toTranslate("Whole teeth with which a drawn train has wanted ratios, all of them or the best."),
    kTeethOptions,
    runTeeth,
    false,
    false};

}  // namespace geargraph::cli
