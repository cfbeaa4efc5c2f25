// `gearbox WISH` and `gearbox merge FILES`: gearboxes with wanted ratios.

#include <array>
#include <cstdio>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/gearbox_files.h"
#include "app/cli/text_table.h"
#include "app/cli/time_limit.h"
#include "core/design/gearboxes/gearbox_document.h"
#include "core/design/gearboxes/gearbox_json.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/folder.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph::cli {
namespace {

constexpr std::int64_t kShownGearboxes = 20;

std::string percentText(const Rational& part) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3f %%", 100 * part.toDouble());
  return part.isZero() ? translated("exact") : buffer;
}

std::string joined(const std::vector<std::string>& words, std::string_view separator) {
  std::string text;
  for (const std::string& each : words) text += (text.empty() ? "" : std::string(separator)) + each;
  return text;
}

std::string elementLetter(int position) {
  return {static_cast<char>('A' + position)};
}

/// "A: S1 = 0, B: in = R1": what the elements join; 0 is the housing.
std::string elementsLine(const BasicSets& sets, const Gearbox& gearbox) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < gearbox.elements.size(); ++i) {
    const ElementLinks& each = gearbox.elements[i];
    words.push_back(elementLetter(static_cast<int>(i)) + ": " + linkWord(sets, gearbox.layout, each.a) +
                    " = " + (each.isBrake() ? "0" : linkWord(sets, gearbox.layout, each.b)));
  }
  return joined(words, ", ");
}

std::string linksLine(const GearboxWish& wish, const BasicSets& sets, const Gearbox& gearbox) {
  std::vector<std::string> links;
  for (int link = 1; link <= wish.limits.shafts; ++link)
    links.push_back(joined(membersOn(sets, gearbox.layout, link), " "));
  const std::vector<std::string> held = membersOn(sets, gearbox.layout, 0);
  if (!held.empty()) links.push_back(joined(held, " ") + " = 0");
  return joined(links, " | ");
}

std::string teethLine(const Gearbox& gearbox) {
  std::vector<std::string> sets;
  for (const TeethOption& option : gearbox.teeth) {
    std::vector<std::string> parts;
    for (const SetTeeth& part : option.parts) {
      std::vector<std::string> numbers{std::to_string(part.sun), std::to_string(part.planet)};
      if (part.outer != 0) numbers.push_back(std::to_string(part.outer));
      numbers.push_back(std::to_string(part.ring));
      parts.push_back(joined(numbers, " "));
    }
    sets.push_back(joined(parts, " + "));
  }
  return joined(sets, " | ");
}

TextRows statesTable(const Gearbox& gearbox) {
  TextRows rows{{translated("state"), translated("engaged"), translated("ratio"), translated("decimal"),
                 translated("error"), translated("efficiency"), translated("circulating")}};
  const auto numberOr = [](const std::optional<Rational>& value) {
    return value ? readableNumber(value->toDouble()) : std::string("-");
  };
  for (std::size_t i = 0; i < gearbox.gears.size(); ++i) {
    const GearState& gear = gearbox.gears[i];
    std::vector<std::string> engaged;
    for (const int each : gear.engaged) engaged.push_back(elementLetter(each));
    rows.push_back({gear.name, joined(engaged, " "), gear.ratio.toString(),
                    readableNumber(gear.ratio.toDouble()), percentText(gear.error),
                    gearbox.losses ? numberOr(gearbox.losses->efficiencies[i]) : "-",
                    gearbox.losses ? numberOr(gearbox.losses->circulating[i]) : "-"});
  }
  return rows;
}

/// One gearbox for people.
std::string gearboxText(const GearboxWish& wish, const Gearbox& gearbox, std::size_t number) {
  const BasicSets sets = basicSets(wish.limits.kinds);
  const GearMeasures& measures = gearbox.measures;
  std::string text = translated("No. %1: %2 elements, largest error %3",
                                {std::to_string(number), std::to_string(gearbox.elements.size()),
                                 percentText(gearbox.error)}) +
                     '\n';
  text += "  " + linksLine(wish, sets, gearbox) + '\n';
  text += "  " + elementsLine(sets, gearbox) + '\n';
  text += "  " + translated("Teeth, sun planet ring: %1", {teethLine(gearbox)}) + '\n';
  text += "  " +
          translated(
              "Largest over that of the input: power through a member %1, torque of an element %2, slip "
              "of an open element %3, speed of a link %4",
              {readableNumber(measures.power.toDouble()), readableNumber(measures.torque.toDouble()),
               readableNumber(measures.slip.toDouble()), readableNumber(measures.speed.toDouble())}) +
          '\n';
  text += "  " +
          (gearbox.brokenRule ? sectionRuleReason(*gearbox.brokenRule)
                              : translated("Its section can be drawn without crossing shafts.")) +
          '\n';
  return text + aligned(translated("States"), statesTable(gearbox)) + '\n';
}

/// What was searched, and that this is not all there is.
std::string searchedText(const GearboxWish& wish, const GearboxSearch& search) {
  std::string text = translated("%1 layouts, %2 found",
                                {std::to_string(search.layouts), std::to_string(search.found.size())}) +
                     '\n';
  if (search.isComplete) {
    return text +
           translated(
               "Complete: these elements have fewer states than gears are wanted, or no layout "
               "has so many links.") +
           '\n';
  }
  const auto sets = static_cast<int>(basicSets(wish.limits.kinds).size());
  const bool isGrid = wish.limits.shafts - sets < kMaxFreedom;
  return text +
         translated("All layouts were searched, but ring ratios at %1 only: sampled, not a proof.",
                    {isGrid ? translated("%1 values for each set", {std::to_string(wish.steps)})
                            : translated("%1 points", {std::to_string(kSamples)})}) +
         '\n';
}

/// Writes the documents of the first gearboxes into a folder; returns the exit status.
int writeDocuments(const Arguments& arguments, const GearboxWish& wish, const GearboxSearch& search,
                   std::int64_t limit) {
  FolderFiles files;
  for (std::size_t i = 0; i < search.found.size() && static_cast<std::int64_t>(i) < limit; ++i) {
    files.emplace_back("gearbox-" + std::to_string(i + 1) + ".geargraph",
                       writeMechanism(gearboxDocument(wish, search.found[i])));
  }
  const auto failure =
      writeFolder(arguments.value("-o").value(), files, {arguments.has("--force"), arguments.stop, {}});
  return failure ? fileFailure(failure->message) : kFine;
}

int show(const Arguments& arguments, const GearboxWish& wish, GearboxSearch search) {
  std::int64_t limit = kShownGearboxes;
  if (const auto word = arguments.value("--limit")) {
    const auto given = numberFrom<std::int64_t>(*word);
    if (!given || *given < 0) return wrongUsage(kGearbox, translated("--limit is a whole number."));
    limit = *given;
  }
  if (arguments.has("-o")) {
    const int status = writeDocuments(arguments, wish, search, limit);
    if (status != kFine) return status;
  }
  if (arguments.has("--json")) {
    const auto json = gearboxesJson(wish, std::move(search), limit, arguments.stop);
    return json ? print(*json) : outOfTime(arguments, translated("the search"));
  }
  std::string text = searchedText(wish, search) + '\n';
  for (std::size_t i = 0; i < search.found.size() && static_cast<std::int64_t>(i) < limit; ++i) {
    if (checkByDocument(wish, search.found[i], true, arguments.stop) == GearboxCheck::stopped)
      return outOfTime(arguments, translated("the search"));
    text += gearboxText(wish, search.found[i], i + 1);
  }
  return print(text);
}

int mergeGearboxes(Arguments arguments) {
  arguments.files.erase(arguments.files.begin());
  if (arguments.files.empty()) return wrongUsage(kGearbox, translated("merge needs the files of parts."));
  for (const std::string_view option : {"--shard", "--resume", "--jobs"}) {
    if (arguments.has(option))
      return wrongUsage(kGearbox, translated("%1 has no meaning for gearbox merge.", {option}));
  }
  auto merged = mergeOrSay(arguments);
  if (const int* status = std::get_if<int>(&merged)) return *status;
  auto& [wish, search] = std::get<MergedSearch>(merged);
  return show(arguments, wish, std::move(search));
}

int runGearbox(const Arguments& arguments) {
  if (!arguments.files.empty() && arguments.files.front() == "merge") return mergeGearboxes(arguments);
  if (arguments.files.size() != 1) return wrongUsage(kGearbox, translated("One wish is needed."));
  if (arguments.has("--parts")) return wrongUsage(kGearbox, translated("--parts is for gearbox merge."));
  const auto jobs = jobsFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&jobs)) return wrongUsage(kGearbox, error->message);
  const auto shardWord = arguments.value("--shard");
  const auto shard = shardWord ? shardFrom(*shardWord) : std::nullopt;
  if (shardWord && !shard) {
    return wrongUsage(
        kGearbox, translated("--shard is R/N, the part R of N, counted from 0, not \"%1\".", {*shardWord}));
  }
  if (shard && !arguments.has("-o"))
    return wrongUsage(kGearbox, translated("--shard needs a file: -o FILE."));
  if (arguments.has("--resume") && !shard) return wrongUsage(kGearbox, translated("--resume needs --shard."));
  auto read = readWishOrSay<GearboxWish>(arguments.files.front(), readGearboxWish);
  if (const int* status = std::get_if<int>(&read)) return *status;
  const auto& wish = std::get<GearboxWish>(read);
  if (shard) return searchShard(arguments, wish, *shard, std::get<int>(jobs));
  GearboxRunOptions options;
  options.threads = std::get<int>(jobs);
  SearchProgress say;
  std::size_t found = 0;
  options.onBlock = [&](const GearboxSearch& block, std::int64_t done, std::int64_t total) {
    found += block.found.size();
    say(done, total, found);
    return true;
  };
  auto search = findGearboxes(wish, options, arguments.stop);
  if (!search) return outOfTime(arguments, translated("the search"));
  return show(arguments, wish, *std::move(search));
}

constexpr std::array kGearboxOptions = {
    Option{"--limit", "N", toTranslate("how many gearboxes are shown and written (20)")},
    Option{"--jobs", "N", toTranslate("how many layouts are searched at once (all processors but one)")},
    Option{"--json", "", toTranslate("as JSON")},
    Option{"-o", "OUT", toTranslate("a folder for the documents; with --shard the file of the part")},
    Option{"--force", "", toTranslate("overwrites files in the folder")},
    Option{"--shard", "R/N", toTranslate("searches the part R of N only, counted from 0, into a file"),
           toTranslate("On many machines")},
    Option{"--resume", "", toTranslate("goes on where the part was stopped; nothing if it is finished"),
           toTranslate("On many machines")},
    Option{"--parts", "FILE", toTranslate("merge: writes the merged parts, of which some may be missing"),
           toTranslate("On many machines")},
};

constexpr std::array<std::string_view, 3> kGearboxUnserved = {"--shard", "--resume", "--parts"};

}  // namespace

const Command kGearbox = {
    "gearbox",
    "WISH [--limit N] [-o FOLDER] [--json] | WISH --shard R/N [--resume] -o FILE | merge FILES...",
    toTranslate("Gearboxes from planetary sets, brakes and clutches with wanted ratios."),
    kGearboxOptions,
    runGearbox,
    false,
    true,
    nullptr,
    MethodInput::wish,
    kGearboxUnserved};

}  // namespace geargraph::cli
