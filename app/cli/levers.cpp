// `levers FILE ...`: the links of the ground's axis as points on levers.

#include <array>
#include <iostream>

#include "app/cli/analyze_document.h"
#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/load.h"
#include "app/cli/text_table.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/readable.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/diagrams/lever_words.h"
#include "core/presentation/export_api/levers_json.h"

namespace geargraph::cli {
namespace {

/// Is the point there, with all of its links, for all tooth counts?
bool isForAllTeeth(const LeverPoint& point) {
  return point.isByMeshes && point.isOneByMeshes;
}

/// A table a lever: its points, from one end to the other.
std::string leverTable(const LeverPicture& picture, std::size_t position) {
  const LeverPlan& plan = picture.plan;
  const Lever& lever = plan.levers[position];
  const bool hasSpeeds = !picture.speeds.empty();
  const bool hasTorques = position < picture.torques.size() && !picture.torques[position].empty();
  TextRows rows{{translated("link"), translated("place")}};
  if (hasSpeeds) rows[0].push_back(translated("rad/s"));
  if (hasTorques) rows[0].push_back(translated("N m"));
  for (std::size_t i = 0; i < lever.points.size(); ++i) {
    const LeverPoint& point = lever.points[i];
    std::vector<std::string> row{labelsOf(point.links),
                                 point.at.toString() + (isForAllTeeth(point) ? "" : " *")};
    if (hasSpeeds)
      row.push_back(
          readableNumber(picture.speeds[static_cast<std::size_t>(plan.positionOf(point.links.front()))]));
    if (hasTorques) row.push_back(readableNumber(picture.torques[position][i]));
    rows.push_back(std::move(row));
  }
  const std::string sets = setsOf(lever);
  return aligned(sets.empty() ? translated("no set") : sets + "  " + teethOf(plan, lever), rows);
}

std::string leversText(const Mechanism& mechanism, const LeverPicture& picture) {
  const LeverPlan& plan = picture.plan;
  const std::string name = titleOf(mechanism);
  if (plan.levers.empty()) return name + ". " + absenceSentence(mechanism, plan) + '\n';
  const std::string freedom = std::to_string(plan.freedom);
  std::string text =
      (plan.levers.size() == 1
           ? translated("%1: 1 lever, freedom %2", {name, freedom})
           : translated("%1: %2 levers, freedom %3", {name, std::to_string(plan.levers.size()), freedom})) +
      "\n";
  bool hasAccidental = false;
  for (std::size_t i = 0; i < plan.levers.size(); ++i) {
    text += '\n' + leverTable(picture, i);
    for (const LeverPoint& point : plan.levers[i].points) hasAccidental |= !isForAllTeeth(point);
  }
  if (hasAccidental) text += '\n' + translated("* there by these tooth counts only") + '\n';
  for (const auto& links : plan.coincident())
    text += '\n' + turnsAsOne(links, plan.areOneByMeshes(links)) + '\n';
  return text;
}

int runLevers(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kLevers, translated("One file is needed."));
  const std::string& file = arguments.files.front();
  const auto loaded = load(file, kLevers);
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  auto document = std::get<Expected<Mechanism>>(loaded);
  if (!document) {
    std::cerr << diagnosticLines(file, document.error());
    return arguments.has("--json") ? print(leversJson(nullptr, nullptr), kMechanismErrors) : kMechanismErrors;
  }
  auto engaged = withEngagementOptions(*std::move(document), arguments);
  if (const auto* error = std::get_if<UsageError>(&engaged)) return wrongUsage(kLevers, error->message);
  const auto analyzed = analyzeAndReport(std::get<Mechanism>(std::move(engaged)), arguments);
  if (const int* status = std::get_if<int>(&analyzed)) return *status;
  const auto& snapshot = std::get<SnapshotPtr>(analyzed);
  const auto picture = leverPictureOf(*snapshot, arguments.stop);
  if (!picture) return outOfTime(arguments, translated("the levers"));
  const bool isTooLarge = picture->plan.absence == LeverAbsence::tooLarge;
  const int status = hasErrors(snapshot->diagnostics) ? kMechanismErrors
                     : isTooLarge                     ? kResourceLimit
                                                      : kFine;
  if (arguments.has("--json")) return print(leversJson(snapshot.get(), &*picture), status);
  return print(leversText(*snapshot->mechanism, *picture), status);
}

constexpr std::array kLeversOptions = {
    kStateOption,
    kEngageOption,
    Option{"--json", "", toTranslate("as JSON")},
};

}  // namespace

const Command kLevers = {
    "levers", "FILE [--state NAME] [--json]",
    toTranslate("The levers of a train: where the links of the ground's axis have their points."),
    kLeversOptions, runLevers};

}  // namespace geargraph::cli
