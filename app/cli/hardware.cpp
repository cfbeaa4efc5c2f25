// `hardware WISH`: the sets that may be inside a hub gear with these ratios.

#include <array>

#include "app/cli/command.h"
#include "app/cli/gearbox_files.h"
#include "app/cli/text_table.h"
#include "app/cli/time_limit.h"
#include "core/design/gearboxes/hub_document.h"
#include "core/design/gearboxes/hub_json.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/folder.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph::cli {
namespace {

constexpr std::int64_t kShownHubs = 20;

std::string numbersLine(const std::vector<int>& numbers) {
  std::string text;
  for (const int each : numbers) text += (text.empty() ? "" : " ") + std::to_string(each);
  return text.empty() ? translated("none") : text;
}

std::string positionsLine(const std::vector<std::size_t>& positions) {
  std::string text;
  for (const std::size_t each : positions) text += (text.empty() ? "" : ", ") + std::to_string(each + 1);
  return text;
}

/// A row for each candidate: the teeth of its sets, the numbers of planets, and the ratios.
std::string candidatesText(const std::string& title, const std::vector<HubCandidate>& candidates,
                           std::int64_t limit) {
  if (candidates.empty()) return {};
  TextRows rows{{translated("no."), translated("sun on planet, ring of each set"), translated("planets"),
                 translated("ratios")}};
  for (std::size_t i = 0; i < candidates.size() && static_cast<std::int64_t>(i) < limit; ++i) {
    std::string teeth;
    std::string planets;
    for (const HubSet& set : candidates[i].sets) {
      teeth += teeth.empty() ? "" : " | ";
      for (const HubSun& sun : set.suns)
        teeth += std::to_string(sun.teeth) + "/" + std::to_string(sun.planet) + " ";
      teeth += std::to_string(set.ring);
      planets += (planets.empty() ? "" : " | ") + numbersLine(set.planets);
    }
    std::string ratios;
    for (const Rational& each : candidates[i].ratios) ratios += (ratios.empty() ? "" : " ") + each.toString();
    rows.push_back({std::to_string(i + 1), teeth, planets, ratios});
  }
  return aligned(title, rows) + '\n';
}

std::string questionLine(const HubQuestion& question) {
  std::string answers;
  for (const auto& [answer, candidates] : leftBy(question)) {
    answers += (answers.empty() ? "" : "; ") + (answer.empty() ? translated("none") : answer) + ": " +
               positionsLine(candidates);
  }
  if (question.isCount)
    return translated("Count %1. By the number of teeth there remain %2.", {question.name, answers});
  return translated("Turn the input %1 times in %2. By the degrees of the output there remain %3.",
                    {std::to_string(kMeasuredTurns), question.name, answers});
}

std::string hubsText(const HubSearch& search, std::int64_t limit) {
  const std::size_t fitting = search.assembled.size() + search.others.size();
  std::string text = translated(
                         "%1 candidates of %2 tooth sets with these ratios. All tooth sets of the "
                         "structures with the fewest suns were tried.",
                         {std::to_string(search.assembled.size()), std::to_string(fitting)}) +
                     "\n\n";
  text += candidatesText(translated("Candidates"), search.assembled, limit);
  text += candidatesText(translated("No equal planets at equal distances can be assembled"), search.others,
                         limit);
  std::string shared;
  for (const auto& [name, teeth] : sharedWheels(search))
    shared += (shared.empty() ? "" : ", ") + name + " " + std::to_string(teeth);
  if (!shared.empty() && search.assembled.size() > 1)
    text += translated("All candidates share: %1.", {shared}) + '\n';
  for (const auto& group : inseparable(search))
    text += translated("Candidates %1 have the same ratios: no turning tells them apart.",
                       {positionsLine(group)}) +
            '\n';
  if (!search.questions.empty()) text += questionLine(search.questions.front()) + '\n';
  return text;
}

int runHardware(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kHardware, translated("One wish is needed."));
  std::int64_t limit = kShownHubs;
  if (const auto word = arguments.value("--limit")) {
    const auto given = numberFrom<std::int64_t>(*word);
    if (!given || *given < 0) return wrongUsage(kHardware, translated("--limit is a whole number."));
    limit = *given;
  }
  auto read = readWishOrSay<HubWish>(arguments.files.front(), readHubWish);
  if (const int* status = std::get_if<int>(&read)) return *status;
  const auto& wish = std::get<HubWish>(read);
  const auto search = findHubs(wish, arguments.stop);
  if (!search) return outOfTime(arguments, translated("the search"));
  if (arguments.has("-o")) {
    FolderFiles files;
    for (const HubCandidate& each : search->assembled) {
      if (static_cast<std::int64_t>(files.size()) == limit) break;
      files.emplace_back("hub-" + std::to_string(files.size() + 1) + ".geargraph",
                         writeMechanism(hubDocument(each)));
    }
    const auto failure =
        writeFolder(arguments.value("-o").value(), files, {arguments.has("--force"), arguments.stop, {}});
    if (failure) return fileFailure(failure->message);
  }
  return print(arguments.has("--json") ? hardwareJson(wish, *search, limit) : hubsText(*search, limit));
}

constexpr std::array kHardwareOptions = {
    Option{"--limit", "N", toTranslate("how many candidates are shown (20)")},
    Option{"--json", "", toTranslate("as JSON")},
    Option{"-o", "FOLDER", toTranslate("a folder for the documents of the candidates")},
    Option{"--force", "", toTranslate("overwrites files in the folder")},
};

}  // namespace

const Command kHardware = {"hardware",
                           "WISH [--limit N] [-o FOLDER] [--json]",
                           toTranslate("The planetary sets that may be inside a hub gear with these ratios."),
                           kHardwareOptions,
                           runHardware,
                           false,
                           true,
                           nullptr,
                           MethodInput::wish};

}  // namespace geargraph::cli
