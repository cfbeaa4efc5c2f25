// `identify FILE [--with FILE] [--choices] [--json]`: which chains of the atlas a train is made of, and
// whether two trains are the same.

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>

#include "app/cli/atlas_output.h"
#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/load.h"
#include "app/cli/time_limit.h"
#include "core/design/atlas/chain_choices.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph::cli {
namespace {

constexpr std::size_t kUsualChoices = 100;
constexpr std::size_t kMaxChoices = 100'000;

/// A document and what it is made of.
struct IdentifiedTrain {
  std::string file;
  Mechanism mechanism;
  DrawnChain drawn;
  TrainIdentity identity;
};

int tooLarge(int links) {
  std::cerr << "geargraph-cli: "
            << translated("Trains of more than %1 links are not identified.", {std::to_string(links)})
            << '\n';
  return kResourceLimit;
}

/// Reads and identifies a document; or reports why not and gives the exit status.
std::variant<IdentifiedTrain, int> identified(const std::string& file, const Arguments& arguments) {
  auto loaded = loadOrSay(file, kIdentify);
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  IdentifiedTrain train{file, std::get<Mechanism>(std::move(loaded)), {}, {}};
  if (train.mechanism.links.size() > kMaxIdentifiedLinks) return tooLarge(kMaxIdentifiedLinks);
  const Placement placement = placementOf(train.mechanism);
  auto drawn = drawnChain(train.mechanism, placement);
  if (!drawn) {
    std::cerr << diagnosticLines(file, drawn.error());
    return static_cast<int>(kMechanismErrors);
  }
  auto identity = identifyTrain(train.mechanism, placement, *drawn, Atlas::shipped(), arguments.stop);
  if (!identity) return outOfTime(arguments, translated("the identification"));
  train.identity = *std::move(identity);
  train.drawn = std::move(drawn).value();
  return train;
}

const std::string& linkIdOf(const IdentifiedTrain& train, int link) {
  return train.mechanism.links[link].id.text();
}

const std::string& meshIdOf(const IdentifiedTrain& train, int mesh) {
  return train.mechanism.gearMeshes[mesh].id.text();
}

void writeNumber(JsonWriter& json, std::string_view name, const std::optional<ChainNumber>& number) {
  json.key(name);
  if (number) {
    json.string(number->toString());
  } else {
    json.null();
  }
}

void writePart(JsonWriter& json, const IdentifiedTrain& train, const IdentifiedChain& part) {
  json.beginObject(JsonWriter::Layout::row);
  json.key("links");
  json.beginArray(JsonWriter::Layout::row);
  for (const int link : part.links) json.string(linkIdOf(train, link));
  json.endArray();
  json.key("meshes");
  json.beginArray(JsonWriter::Layout::row);
  for (const int mesh : part.meshes) json.string(meshIdOf(train, mesh));
  json.endArray();
  json.member("dof", part.dof);
  json.member("locked", part.isLocked);
  writeNumber(json, "rotation", part.rotation);
  writeNumber(json, "displacement", part.displacement);
  json.key("relatives");
  if (part.displacement) {
    writeRelatives(json, relativesOf(part.chain, Atlas::shipped()));
  } else {
    json.null();
  }
  json.endObject();
}

/// The member "with": null where the trains differ.
void writeMatch(JsonWriter& json, const IdentifiedTrain& a, const IdentifiedTrain& b,
                const std::optional<TrainMatch>& match) {
  json.key("with");
  if (!match) return json.null();
  json.beginObject();
  json.member("same", match->likeness == ChainLikeness::displacement ? "displacement" : "rotation");
  json.key("links");
  json.beginObject(JsonWriter::Layout::row);
  for (const auto& [own, other] : match->links) json.member(linkIdOf(a, own), linkIdOf(b, other));
  json.endObject();
  json.key("meshes");
  json.beginObject(JsonWriter::Layout::row);
  for (const auto& [own, other] : match->meshes) json.member(meshIdOf(a, own), meshIdOf(b, other));
  json.endObject();
  json.endObject();
}

void writePairs(JsonWriter& json, const IdentifiedTrain& train, std::string_view name,
                const std::vector<std::vector<TurningPair>>& sets) {
  json.key(name);
  json.beginArray();
  for (const std::vector<TurningPair>& set : sets) {
    json.beginArray(JsonWriter::Layout::row);
    for (const auto& [first, second] : set) {
      json.beginArray(JsonWriter::Layout::row);
      json.string(linkIdOf(train, first));
      json.string(linkIdOf(train, second));
      json.endArray();
    }
    json.endArray();
  }
  json.endArray();
}

/// The member "choices".
void writeChoices(JsonWriter& json, const IdentifiedTrain& train, const ChainChoices& choices) {
  json.key("choices");
  json.beginObject();
  json.key("treeCount");
  if (choices.treeCount) {
    json.string(std::to_string(*choices.treeCount));
  } else {
    json.null();
  }
  writePairs(json, train, "trees", choices.trees);
  json.member("inputSetCount", std::to_string(choices.inputSetCount));
  writePairs(json, train, "inputSets", choices.inputSets);
  json.key("frames");
  json.beginArray(JsonWriter::Layout::row);
  for (const std::vector<int>& frame : choices.frames) {
    json.beginArray(JsonWriter::Layout::row);
    for (const int link : frame) json.string(linkIdOf(train, link));
    json.endArray();
  }
  json.endArray();
  json.endObject();
}

/// What is told of a train beside its chains; null where it was not asked for.
struct IdentityExtras {
  const IdentifiedTrain* other = nullptr;
  std::optional<TrainMatch> match = {};
  std::optional<ChainChoices> choices = {};
};

std::string identityJson(const IdentifiedTrain& train, const IdentityExtras& extras) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-identity");
    json.member("version", 1);
    json.key("removed");
    json.beginArray();
    for (const RemovedLink& removed : train.identity.removed) {
      json.beginObject(JsonWriter::Layout::row);
      json.member("link", linkIdOf(train, removed.link));
      json.member("why", removalName(removed.why));
      json.endObject();
    }
    json.endArray();
    json.key("chains");
    json.beginArray();
    for (const IdentifiedChain& part : train.identity.parts) writePart(json, train, part);
    json.endArray();
    if (extras.other != nullptr) writeMatch(json, train, *extras.other, extras.match);
    if (extras.choices) writeChoices(json, train, *extras.choices);
    json.endObject();
  }
  return sink.take();
}

std::string spacedLabels(const std::vector<int>& labels) {
  std::string text;
  for (const int label : labels) text += (text.empty() ? "" : " ") + std::to_string(label);
  return text;
}

std::string partText(const IdentifiedTrain& train, const IdentifiedChain& part) {
  std::string text = part.displacement ? translated("Chain %1", {part.displacement->toString()})
                                       : translated("A chain that is not in the atlas");
  std::vector<int> meshes;
  for (const int mesh : part.meshes) meshes.push_back(train.mechanism.meshLabel(mesh));
  text += "\n  " + translated("links: %1", {spacedLabels(part.links)}) + "\n  " +
          translated("meshes: %1", {spacedLabels(meshes)}) + "\n  " +
          translated("freedom: %1", {std::to_string(part.dof)}) + '\n';
  if (part.isLocked) text += "  " + translated("locked: two of its links turn as one in every motion") + '\n';
  if (part.turnsByTeeth)
    text += "  " + translated("turns by these tooth counts only; with others it would be locked") + '\n';
  return text + (part.displacement ? relativesText(relativesOf(part.chain, Atlas::shipped())) : "");
}

std::string identityText(const IdentifiedTrain& train) {
  std::string text;
  for (const RemovedLink& removed : train.identity.removed) {
    const std::string label = std::to_string(train.mechanism.linkLabel(removed.link));
    text += (removed.why == RemovalReason::copy
                 ? translated("Left out: link %1, a planet that repeats another", {label})
                 : translated("Left out: link %1, in no mesh", {label})) +
            '\n';
  }
  if (train.identity.parts.empty()) return text + translated("There is no mesh.") + '\n';
  for (const IdentifiedChain& part : train.identity.parts) text += partText(train, part);
  return text;
}

std::string matchText(const IdentifiedTrain& a, const IdentifiedTrain& b,
                      const std::optional<TrainMatch>& match) {
  if (!match) return translated("%1 and %2 are different chains.", {a.file, b.file}) + '\n';
  std::string text =
      match->likeness == ChainLikeness::displacement
          ? translated("%1 and %2 are the same chain.", {a.file, b.file})
          : translated("%1 and %2 have the same equations, on other shafts.", {a.file, b.file});
  const auto added = [](std::string& line, int own, int other) {
    line += (line.empty() ? "" : " ") + std::to_string(own) + '=' + std::to_string(other);
  };
  std::string links;
  for (const auto& [own, other] : match->links)
    added(links, a.mechanism.linkLabel(own), b.mechanism.linkLabel(other));
  std::string meshes;
  for (const auto& [own, other] : match->meshes)
    added(meshes, a.mechanism.meshLabel(own), b.mechanism.meshLabel(other));
  return text + "\n  " + translated("links: %1", {links}) + "\n  " + translated("meshes: %1", {meshes}) +
         '\n';
}

/// "0-1 1-4": pairs of labels.
std::string pairsText(const Mechanism& mechanism, const std::vector<TurningPair>& pairs) {
  std::string text;
  for (const auto& [first, second] : pairs)
    text += (text.empty() ? "" : " ") + std::to_string(mechanism.linkLabel(first)) + '-' +
            std::to_string(mechanism.linkLabel(second));
  return text;
}

std::string choicesText(const IdentifiedTrain& train, const ChainChoices& choices) {
  const auto listedBelow = [&](const std::vector<std::vector<TurningPair>>& sets, const std::string& count) {
    std::string text;
    for (const std::vector<TurningPair>& set : sets) {
      const std::string pairs = pairsText(train.mechanism, set);
      text += "  " + (pairs.empty() ? translated("none") : pairs) + '\n';
    }
    return count == std::to_string(sets.size()) ? text : text + "  ...\n";
  };
  const std::string trees = choices.treeCount ? std::to_string(*choices.treeCount) : translated("over 2^63");
  const std::string inputs = std::to_string(choices.inputSetCount);
  std::string text =
      translated("Trees of turning joints: %1", {trees}) + '\n' + listedBelow(choices.trees, trees);
  text += translated("Valid sets of inputs, as pairs of links: %1", {inputs}) + '\n' +
          listedBelow(choices.inputSets, inputs);
  text += translated("Links that differ as the frame: %1", {std::to_string(choices.frames.size())}) + '\n';
  for (const std::vector<int>& frame : choices.frames) text += "  " + spacedLabels(frame) + '\n';
  return text;
}

/// The choices that --choices asks for; or reports why there are none and gives the exit status.
std::variant<std::optional<ChainChoices>, int> choicesFrom(const Arguments& arguments,
                                                           const IdentifiedTrain& train) {
  if (!arguments.has("--choices")) return std::optional<ChainChoices>();
  std::size_t most = kUsualChoices;
  if (const auto word = arguments.value("--limit")) {
    const auto given = numberFrom<std::size_t>(*word);
    if (!given) return wrongUsage(kIdentify, translated("--limit is a whole number."));
    most = std::min(*given, kMaxChoices);
  }
  auto choices = choicesOf(train.drawn.chain, train.drawn.teeth, most, arguments.stop);
  if (choices) return choices;
  if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the identification"));
  std::cerr << "geargraph-cli: "
            << translated("There are more than %1 sets of inputs to try; they are not listed.",
                          {std::to_string(kMaxInputTrials)})
            << '\n';
  return static_cast<int>(kResourceLimit);
}

int runIdentify(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kIdentify, translated("One file is needed."));
  if (arguments.has("--limit") && !arguments.has("--choices"))
    return wrongUsage(kIdentify, translated("%1 has no meaning without %2.", {"--limit", "--choices"}));
  const auto train = identified(arguments.files.front(), arguments);
  if (const int* status = std::get_if<int>(&train)) return *status;
  const auto& own = std::get<IdentifiedTrain>(train);
  IdentityExtras extras;
  auto choices = choicesFrom(arguments, own);
  if (const int* status = std::get_if<int>(&choices)) return *status;
  extras.choices = std::get<0>(std::move(choices));
  std::optional<IdentifiedTrain> other;
  if (const auto path = arguments.value("--with")) {
    auto second = identified(*path, arguments);
    if (const int* status = std::get_if<int>(&second)) return *status;
    other = std::get<IdentifiedTrain>(std::move(second));
    if (std::max(own.identity.chain.links, other->identity.chain.links) > kMaxMatchedLinks)
      return tooLarge(kMaxMatchedLinks);
    extras.other = &*other;
    extras.match = matchOf(own.identity, other->identity);
  }
  if (arguments.has("--json")) return print(identityJson(own, extras));
  return print(identityText(own) + (other ? matchText(own, *other, extras.match) : "") +
               (extras.choices ? choicesText(own, *extras.choices) : ""));
}

constexpr std::array kIdentifyOptions = {
    Option{"--with", "FILE", toTranslate("another document: is it the same chain, and which link is which?")},
    Option{"--choices", "", toTranslate("also the trees, inputs and frames by which the train can be drawn")},
    Option{"--limit", "N", toTranslate("with --choices: how many of each are listed (100)")},
    Option{"--json", "", toTranslate("as JSON")},
};

constexpr std::array<std::string_view, 1> kIdentifyUnserved = {"--with"};

}  // namespace

const Command kIdentify = {.name = "identify",
                           .usage = "FILE [--with FILE] [--choices [--limit N]] [--json]",
                           .summary = toTranslate("Which chains of the atlas a train is made of."),
                           .options = kIdentifyOptions,
                           .run = runIdentify,
                           .servedInput = MethodInput::twoDocuments,
                           .unserved = kIdentifyUnserved};

}  // namespace geargraph::cli
