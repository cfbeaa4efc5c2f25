// `atlas [NUMBER] [--links N] [--dof F] ... [-o FILE]`: geared kinematic chains, counted, listed, and as
// documents.

#include <algorithm>
#include <array>
#include <iostream>

#include "app/cli/atlas_output.h"
#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/text_table.h"
#include "app/cli/time_limit.h"
#include "core/design/atlas/chain_document.h"
#include "core/design/atlas/identify.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/foundations/files/json_writer.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph::cli {
namespace {

/// Which chains are listed.
struct ChainFilter {
  std::optional<int> links;
  int dof = 1;
  std::optional<int> axes;
  bool isNonfractionatedOnly = false;

  [[nodiscard]] bool takes(const AtlasChain& chain) const {
    return (!links || chain.number.links == *links) && chain.number.dof == dof &&
           (!axes || chain.chain.axes.size() == static_cast<std::size_t>(*axes)) &&
           (!isNonfractionatedOnly || isNonfractionated(chain.chain));
  }
};

/// The value of an option as a number of this range; std::nullopt if it is not given.
std::variant<std::optional<int>, UsageError> wholeOption(const Arguments& arguments, std::string_view name,
                                                         int least, int most) {
  const auto word = arguments.value(name);
  if (!word) return std::optional<int>();
  const auto number = numberFrom<int>(*word);
  if (!number || *number < least || *number > most)
    return UsageError{
        translated("%1 is a whole number, %2 to %3.", {name, std::to_string(least), std::to_string(most)})};
  return number;
}

std::variant<ChainFilter, UsageError> filterFrom(const Arguments& arguments) {
  ChainFilter filter;
  std::array<std::optional<int>, 3> numbers;
  const std::array<std::tuple<std::string_view, int, int>, 3> options = {
      {{"--links", 3, 9}, {"--dof", 0, 2}, {"--axes", 2, 8}}};
  for (std::size_t i = 0; i < options.size(); ++i) {
    const auto& [name, least, most] = options[i];
    auto number = wholeOption(arguments, name, least, most);
    if (const auto* error = std::get_if<UsageError>(&number)) return *error;
    numbers[i] = std::get<std::optional<int>>(number);
  }
  filter.links = numbers[0];
  filter.dof = numbers[1].value_or(1);
  filter.axes = numbers[2];
  filter.isNonfractionatedOnly = arguments.has("--nonfractionated");
  return filter;
}

std::vector<AtlasChain> chosenChains(const Atlas& atlas, const ChainFilter& filter) {
  std::vector<AtlasChain> chains;
  std::copy_if(atlas.chains().begin(), atlas.chains().end(), std::back_inserter(chains),
               [&](const AtlasChain& chain) { return filter.takes(chain); });
  return chains;
}

std::string chainsJson(const std::vector<AtlasChain>& chains) {
  TextSink sink;
  {
    JsonWriter json(sink);
    const ChainCounts counts = countsOf(chains);
    json.beginObject();
    json.member("format", "geargraph-atlas");
    json.member("version", 1);
    json.member("rotationCount", counts.rotations);
    json.member("displacementCount", counts.displacements);
    json.key("chains");
    json.beginArray();
    for (const AtlasChain& chain : chains) {
      json.beginObject(JsonWriter::Layout::row);
      json.member("number", chain.number.toString());
      writeChainMembers(json, chain.chain);
      json.endObject();
    }
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

std::string definitionText() {
  return translated(
             "A chain is links, axes and gear pairs, each pair with the link that carries both gears. Frame, "
             "teeth, kinds of gears\nand the joints by which coaxial links are drawn do not matter. "
             "Equations: "
             "rotation graphs, the triples gear, gear, carrier.\nChains: displacement graphs, which tell "
             "shafts "
             "apart, too. Left out: chains where m gear pairs have fewer than m + 2\nlinks between them, so "
             "that these turn as one; the smallest of them are listed with freedom 0.") +
         '\n' +
         translated(
             "Counts of chains with 1 freedom as in Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301: "
             "27 "
             "and 81 with 6 links, 152\nand 647 with 7, 1070 and 6360 with 8. Nonfractionated chains with 2 "
             "freedoms: see Tsai, Lin, J. Mech. Transm. Autom. Des.\n111(4), 1989, 524.") +
         '\n';
}

std::string countsText(const Atlas& atlas) {
  TextRows rows{{translated("links"), translated("freedom"), translated("equations"), translated("chains"),
                 translated("nonfractionated equations"), translated("chains")}};
  for (int dof = 0; dof <= 2; ++dof) {
    for (int links = 3; links <= atlas.mostLinks(dof); ++links) {
      const auto chains = atlas.chains(links, dof);
      if (chains.empty()) continue;
      std::vector<AtlasChain> whole;
      std::copy_if(chains.begin(), chains.end(), std::back_inserter(whole),
                   [](const AtlasChain& chain) { return isNonfractionated(chain.chain); });
      const ChainCounts all = countsOf(chains);
      const ChainCounts unparted = countsOf(whole);
      rows.push_back({std::to_string(links), std::to_string(dof), std::to_string(all.rotations),
                      std::to_string(all.displacements), std::to_string(unparted.rotations),
                      std::to_string(unparted.displacements)});
    }
  }
  return aligned(translated("Geared kinematic chains, one link held"), rows) + '\n' + definitionText();
}

std::string listText(const std::vector<AtlasChain>& chains) {
  const ChainCounts counts = countsOf(chains);
  TextRows rows{{translated("number"), translated("axes"), translated("gear pairs / carrier")}};
  for (const AtlasChain& chain : chains)
    rows.push_back({chain.number.toString(), axesText(chain.chain), meshesText(chain.chain)});
  return translated("Equations: %1, chains: %2",
                    {std::to_string(counts.rotations), std::to_string(counts.displacements)}) +
         '\n' + aligned("", rows) + '\n' + definitionText();
}

std::string chainText(const AtlasChain& chain, const Atlas& atlas) {
  std::string text = translated("Chain %1", {chain.number.toString()}) + '\n' + "  " +
                     translated("axes: %1", {axesText(chain.chain)}) + "\n  " +
                     translated("gear pairs / carrier: %1", {meshesText(chain.chain)}) + '\n';
  if (const auto locked = degenerateMeshes(chain.chain))
    text += "  " + lockedText(chain.chain, *locked) + '\n';
  return text + relativesText(relativesOf(chain.chain, atlas));
}

/// The atlas of --file, else that of the program; or the exit status.
std::variant<const Atlas*, int> atlasFrom(const Arguments& arguments, std::optional<Atlas>& own) {
  const auto path = arguments.value("--file");
  if (!path) return &Atlas::shipped();
  const auto bytes = readFile(*path, kLargestFile);
  if (const auto* error = std::get_if<FileError>(&bytes)) return fileFailure(error->message);
  auto read = Atlas::read(std::get<std::string>(bytes));
  if (!read) {
    std::cerr << diagnosticLines(*path, read.error());
    return static_cast<int>(kUsageOrFile);
  }
  own = std::move(read).value();
  return &*own;
}

std::variant<ChainDrawing, UsageError> drawingFrom(const Arguments& arguments, const Chain& chain) {
  ChainDrawing drawing;
  const auto frame = wholeOption(arguments, "--frame", 1, chain.links);
  if (const auto* error = std::get_if<UsageError>(&frame)) return *error;
  if (const auto& link = std::get<std::optional<int>>(frame)) drawing.frame = *link - 1;
  const int pairs = static_cast<int>(chain.meshes.size());
  for (const std::string& word : arguments.values("--ring")) {
    const auto ring = numberFrom<int>(word);
    if (!ring || *ring < 1 || *ring > pairs)
      return UsageError{
          translated("%1 is a whole number, %2 to %3.", {"--ring", "1", std::to_string(pairs)})};
    drawing.rings.push_back(*ring - 1);
  }
  return drawing;
}

int runOneChain(const Arguments& arguments, const Atlas& atlas) {
  for (const char* const option : {"--links", "--dof", "--axes", "--nonfractionated"}) {
    if (arguments.has(option))
      return wrongUsage(kAtlas, translated("%1 has no meaning with a number of a chain.", {option}));
  }
  const std::string& word = arguments.files.front();
  const auto number = ChainNumber::fromText(word);
  if (!number)
    return wrongUsage(kAtlas, translated("\"%1\" is no number of a chain, as 6-1.5.1 is.", {word}));
  const AtlasChain* const chain = number->displacement > 0 ? atlas.find(*number) : nullptr;
  const std::span<const AtlasChain> group = atlas.group(*number);
  if (chain == nullptr && (number->displacement > 0 || group.empty()))
    return wrongUsage(kAtlas, translated("The atlas has no chain %1.", {word}));
  const auto out = arguments.value("-o");
  if (!out) {
    const std::vector<AtlasChain> listed = chain != nullptr
                                               ? std::vector<AtlasChain>{*chain}
                                               : std::vector<AtlasChain>(group.begin(), group.end());
    if (arguments.has("--json")) return print(chainsJson(listed));
    return print(chain != nullptr ? chainText(*chain, atlas) : listText(listed));
  }
  if (chain == nullptr)
    return wrongUsage(kAtlas, translated("\"%1\" are equations; a document needs a chain, as %2 is.",
                                         {word, group.front().number.toString()}));
  const auto drawing = drawingFrom(arguments, chain->chain);
  if (const auto* error = std::get_if<UsageError>(&drawing)) return wrongUsage(kAtlas, error->message);
  const Mechanism document =
      chainDocument(chain->chain, chain->number.toString(), std::get<ChainDrawing>(drawing), arguments.stop);
  if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the conversion"));
  return writeOutput(writeMechanism(document), *out);
}

int runAtlas(const Arguments& arguments) {
  std::optional<Atlas> own;
  const auto found = atlasFrom(arguments, own);
  if (const int* status = std::get_if<int>(&found)) return *status;
  const Atlas& atlas = *std::get<const Atlas*>(found);
  if (arguments.files.size() > 1) return wrongUsage(kAtlas, translated("One number is enough."));
  if (!arguments.files.empty()) return runOneChain(arguments, atlas);
  for (const char* const option : {"-o", "--frame", "--ring"}) {
    if (arguments.has(option))
      return wrongUsage(kAtlas, translated("%1 needs the number of a chain.", {option}));
  }
  const auto filter = filterFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&filter)) return wrongUsage(kAtlas, error->message);
  const auto& wanted = std::get<ChainFilter>(filter);
  if (wanted.links && *wanted.links > atlas.mostLinks(wanted.dof))
    return wrongUsage(kAtlas, translated("The atlas has chains of up to %1 links with this freedom.",
                                         {std::to_string(atlas.mostLinks(wanted.dof))}));
  if (arguments.has("--json")) return print(chainsJson(chosenChains(atlas, wanted)));
  const bool isFiltered = std::any_of(arguments.options.begin(), arguments.options.end(), [](const auto& o) {
    return o.first == "--links" || o.first == "--dof" || o.first == "--axes" ||
           o.first == "--nonfractionated";
  });
  return print(isFiltered ? listText(chosenChains(atlas, wanted)) : countsText(atlas));
}

constexpr std::array kAtlasOptions = {
    Option{"--links", "N", toTranslate("only chains of so many links (3 to 7)")},
    Option{"--dof", "F", toTranslate("of this freedom: 1 (the default), 2, or 0: trains that cannot turn")},
    Option{"--axes", "N", toTranslate("with so many axes")},
    Option{"--nonfractionated", "", toTranslate("that no link parts, every link in a gear pair")},
    Option{"--json", "", toTranslate("as JSON")},
    Option{"-o", "FILE", toTranslate("write the chain of the number as a document"),
           toTranslate("With a number")},
    Option{"--frame", "LINK", toTranslate("the link that is held"), toTranslate("With a number")},
    Option{"--ring", "PAIR", toTranslate("a gear pair, by its place, with a ring gear; may be repeated"),
           toTranslate("With a number")},
    Option{"--file", "FILE", toTranslate("another atlas than the program's (of geargraph-make-atlas)")},
};

constexpr std::array<std::string_view, 1> kAtlasUnserved = {"--file"};

}  // namespace

const Command kAtlas = {
    .name = "atlas",
    .usage = "[NUMBER [-o FILE]] [--links N] [--dof F] [--axes N] [--nonfractionated] [--json]",
    .summary = toTranslate("Counts and lists geared kinematic chains; writes one as a document."),
    .options = kAtlasOptions,
    .run = runAtlas,
    .servedInput = MethodInput::number,
    .unserved = kAtlasUnserved};

}  // namespace geargraph::cli
