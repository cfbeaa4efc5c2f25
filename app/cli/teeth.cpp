// `teeth FILE WISH` and `teeth --check CERTIFICATE`: whole teeth for wanted ratios, and the proof that there
// are no better ones.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <tuple>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/load.h"
#include "app/cli/text_table.h"
#include "app/cli/time_limit.h"
#include "core/design/teeth_check/teeth_check.h"
#include "core/design/teeth_search/meant_teeth.h"
#include "core/design/teeth_search/teeth_certificate.h"
#include "core/design/teeth_search/teeth_json.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph::cli {
namespace {

constexpr std::size_t kMaxTeethShown = 20;
constexpr std::size_t kMaxChoices = 100'000;
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

std::string asText(const MeantTeeth& meant, std::size_t most) {
  const TeethProblem& problem = *meant.problem;
  TextRows drawn{{translated("ratio"), translated("stated"), translated("drawn")}};
  for (std::size_t i = 0; i < meant.drawn.size(); ++i) {
    drawn.push_back({std::to_string(i + 1), problem.ratios[i].bounds.wanted.toString(),
                     (meant.drawn[i] ? meant.drawn[i]->toString() : translated("none")) +
                         (meant.fits[i] != 0 ? "" : " *")});
  }
  std::string text =
      aligned(translated("Ratios with the drawn teeth; * is not the stated one"), drawn) + '\n';
  if (meant.changed == 0) return text + translated("The drawn teeth have all stated ratios.") + '\n';
  if (meant.changed < 0)
    return text + translated("No teeth near the drawn ones have all stated ratios.") + '\n';
  TextRows rows{{translated("choice"), translated("instead of the drawn teeth"), translated("error")}};
  for (std::size_t i = 0; i < std::min(most, meant.choices.size()); ++i) {
    const MeantChoice& choice = meant.choices[i];
    std::string changes;
    for (const int each : choice.changed) {
      const auto wheel = static_cast<std::size_t>(each);
      changes += (changes.empty() ? "" : ", ") + problem.wheels[wheel].name + ' ' +
                 std::to_string(problem.wheels[wheel].drawn) + " -> " +
                 std::to_string(choice.found.teeth[wheel]);
    }
    rows.push_back({std::to_string(i + 1), changes, percentText(choice.found.error)});
  }
  return text + aligned(translated("Which teeth were meant? Wheels that differ: %1, choices: %2",
                                   {std::to_string(meant.changed), std::to_string(meant.choices.size())}),
                        rows);
}

/// The wheels and teeth by which --meant may differ from the drawn ones.
std::variant<MeantTeethOptions, UsageError> meantOptionsFrom(const Arguments& arguments) {
  MeantTeethOptions options;
  for (const auto& [name, most, value] : {std::tuple("--wheels", kMaxMeantWheels, &options.wheels),
                                          std::tuple("--by", kMaxMeantTeeth, &options.by)}) {
    const auto word = arguments.value(name);
    if (!word) continue;
    const auto number = numberFrom<int>(*word);
    if (!number || *number < 1 || *number > most)
      return UsageError{translated("%1 is a whole number, %2 to %3.", {name, "1", std::to_string(most)})};
    *value = *number;
  }
  return options;
}

int runMeantTeeth(const Arguments& arguments, const PlacedMechanism& drawn, const TeethWish& wish,
                  std::size_t most) {
  const auto options = meantOptionsFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&options)) return wrongUsage(kTeeth, error->message);
  const auto meant = meantTeeth(drawn, wish, std::get<MeantTeethOptions>(options), arguments.stop);
  if (!meant) {
    std::cerr << diagnosticLines(arguments.files.front(), meant.error());
    return kMechanismErrors;
  }
  if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the search"));
  return print(arguments.has("--json") ? meantTeethJson(*meant, most) : asText(*meant, most));
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
  std::size_t most = kMaxTeethShown;
  if (const auto word = arguments.value("--limit")) {
    const auto number = numberFrom<std::size_t>(*word);
    if (!number || *number > kMaxChoices)
      return wrongUsage(kTeeth,
                        translated("--limit is a whole number up to %1.", {std::to_string(kMaxChoices)}));
    most = *number;
  }
  const auto loaded = loadOrSay(arguments.files.front(), kTeeth);
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
  if (arguments.has("--meant")) return runMeantTeeth(arguments, drawn, *wish, most);
  for (const char* const option : {"--wheels", "--by"}) {
    if (arguments.has(option))
      return wrongUsage(kTeeth, translated("%1 has no meaning without %2.", {option, "--meant"}));
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
    Option{"--meant", "",
           toTranslate("the ratios are stated ones: which teeth near the drawn ones have them?")},
    Option{"--wheels", "N", toTranslate("with --meant: wheels that may differ, at most (3)")},
    Option{"--by", "N", toTranslate("with --meant: teeth by which a wheel may differ (5)")},
};

constexpr std::array<std::string_view, 2> kTeethUnserved = {"--certificate", "--check"};

}  // namespace

const Command kTeeth = {
    "teeth",
    "FILE WISH [--limit N] [--certificate FILE] [--json], FILE WISH --meant, or --check CERTIFICATE [--json]",
    toTranslate("Whole teeth with which a drawn train has wanted ratios, all of them or the best."),
    kTeethOptions,
    runTeeth,
    false,
    true,
    nullptr,
    MethodInput::documentAndWish,
    kTeethUnserved};

}  // namespace geargraph::cli
