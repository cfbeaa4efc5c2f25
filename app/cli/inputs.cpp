// `inputs FILE [--json] [--limit N]`: how many valid sets of inputs there are, and the first of them.

#include <array>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/engagement_options.h"
#include "app/cli/load.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/theory/analysis/analysis.h"
#include "core/theory/matroid/input_sets.h"

namespace geargraph::cli {
namespace {

constexpr std::size_t kUsualLimit = 1'000;

struct Sets {
  std::optional<Rational> count;
  std::vector<std::vector<int>> labels;
};

/// Nothing where the mechanism has no kinematics, or is too large.
std::optional<Sets> setsOf(const AnalysisSnapshot& snapshot, std::size_t limit, const std::stop_token& stop) {
  const MatroidAnalysis* matroid = snapshot.matroid();
  if (matroid == nullptr) return std::nullopt;
  const auto found =
      InputSets::of(*snapshot.kinematics->model, ModularDoubleField(), matroid->choice.joints, stop);
  if (!found) return std::nullopt;
  Sets sets{found->count(stop), found->list(limit, stop)};
  for (std::vector<int>& set : sets.labels) {
    for (int& joint : set) joint = snapshot.graph->edgeLabel(joint);
  }
  return sets;
}

std::string asJson(const Sets& sets) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-inputs");
    json.member("version", 1);
    json.key("count");
    if (sets.count) {
      json.string(sets.count->toString());
    } else {
      json.null();
    }
    json.key("sets");
    json.beginArray();
    for (const std::vector<int>& set : sets.labels) {
      json.beginArray(JsonWriter::Layout::row);
      for (const int label : set) json.number(static_cast<std::int64_t>(label));
      json.endArray();
    }
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

std::string asText(const Sets& sets) {
  const std::string count = sets.count ? sets.count->toString() : translated("Too many to count");
  std::string text = sets.count && *sets.count == 1 ? translated("%1 valid set of inputs", {count})
                                                    : translated("%1 valid sets of inputs", {count});
  const bool isAll = sets.count && *sets.count == static_cast<std::int64_t>(sets.labels.size());
  text += isAll ? "\n" : translated("; the first %1:", {std::to_string(sets.labels.size())}) + '\n';
  for (const std::vector<int>& set : sets.labels) {
    std::string line;
    for (const int label : set) line += (line.empty() ? "" : ", ") + std::to_string(label);
    text += "  " + (line.empty() ? translated("(none: nothing can move)") : line) + '\n';
  }
  return text;
}

int tooMany() {
  std::cerr << "geargraph-cli: "
            << translated("There are over 20 million rates of joints over inputs; no sets are listed.")
            << '\n';
  return kResourceLimit;
}

int runInputs(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kInputs, translated("One file is needed."));
  std::size_t limit = kUsualLimit;
  if (const auto word = arguments.value("--limit")) {
    const auto given = numberFrom<std::size_t>(*word);
    if (!given) return wrongUsage(kInputs, translated("--limit is a whole number."));
    limit = *given;
  }
  const std::string& file = arguments.files.front();
  const auto loaded = load(file);
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  const auto& document = std::get<Expected<Mechanism>>(loaded);
  SnapshotPtr snapshot;
  if (document) {
    auto engaged = withEngagementOptions(*document, arguments);
    if (const auto* error = std::get_if<UsageError>(&engaged)) return wrongUsage(kInputs, error->message);
    snapshot = analyzeLive(std::make_shared<const Mechanism>(std::get<Mechanism>(std::move(engaged))), 0,
                           arguments.stop);
  }
  if (document && !snapshot) return outOfTime(arguments, translated("the analysis"));
  const Diagnostics& diagnostics = snapshot ? snapshot->diagnostics : document.error();
  std::cerr << diagnosticLines(file, diagnostics);
  const int status = hasErrors(diagnostics) ? kMechanismErrors : kFine;
  const auto sets = snapshot ? setsOf(*snapshot, limit, arguments.stop) : std::nullopt;
  if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the list of input sets"));
  if (arguments.has("--json"))
    return print(asJson(sets.value_or(Sets{})), sets || status != kFine ? status : tooMany());
  if (sets) return print(asText(*sets), status);
  return status != kFine ? status : tooMany();
}

constexpr std::array kInputsOptions = {
    Option{"--limit", "N", toTranslate("how many sets are listed (1,000)")},
    kStateOption,
    kEngageOption,
    Option{"--json", "", toTranslate("as JSON")},
};

}  // namespace

const Command kInputs = {"inputs", "FILE [--limit N] [--state NAME | --engage A,B] [--json]",
                         toTranslate("Counts and lists the valid sets of inputs."), kInputsOptions,
                         runInputs};

}  // namespace geargraph::cli
