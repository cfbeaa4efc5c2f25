// Gearboxes and hub gears from ratios, and the atlas of geared kinematic chains.

#include <algorithm>
#include <thread>

#include "app/python/bindings/document.h"
#include "app/python/bindings/interruptible.h"
#include "core/design/atlas/chain_document.h"
#include "core/design/atlas/identify.h"
#include "core/design/gearboxes/gearbox_document.h"
#include "core/design/gearboxes/gearbox_json.h"
#include "core/design/gearboxes/hub_document.h"
#include "core/design/gearboxes/hub_json.h"

namespace geargraph::python {
namespace {

/// The answer as JSON, and the documents of what is in it.
using FoundDocuments = std::pair<std::string, std::vector<Document>>;

FoundDocuments gearboxesFor(const std::string& text, std::int64_t limit) {
  const GearboxWish wish = valueOrRaise(readGearboxWish(text));
  GearboxRunOptions options;
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  std::vector<Mechanism> made;
  const auto json = interruptible([&](const std::stop_token& stop) -> std::optional<std::string> {
    auto search = findGearboxes(wish, options, stop);
    if (!search) return std::nullopt;
    const auto shown = std::min(search->found.size(), static_cast<std::size_t>(limit));
    for (std::size_t i = 0; i < shown; ++i) made.push_back(gearboxDocument(wish, search->found[i]));
    return gearboxesJson(wish, *std::move(search), limit, stop);
  });
  FoundDocuments found{json.value_or(""), {}};
  for (Mechanism& each : made) found.second.push_back(edited(std::move(each)));
  return found;
}

FoundDocuments hubsFor(const std::string& text, std::int64_t limit) {
  const HubWish wish = valueOrRaise(readHubWish(text));
  const auto search = interruptible([&](const std::stop_token& stop) { return findHubs(wish, stop); });
  FoundDocuments found;
  if (!search) return found;
  found.first = hardwareJson(wish, *search, limit);
  for (const HubCandidate& each : search->assembled) {
    if (static_cast<std::int64_t>(found.second.size()) == limit) break;
    found.second.push_back(edited(hubDocument(each)));
  }
  return found;
}

/// Number, axes and meshes, links counted from 1.
py::tuple chainRow(const AtlasChain& chain) {
  const auto counted = [](int link) { return link + 1; };
  std::vector<std::vector<int>> axes;
  for (const auto& axis : chain.chain.axes) {
    auto& links = axes.emplace_back();
    std::transform(axis.begin(), axis.end(), std::back_inserter(links), counted);
  }
  std::vector<std::tuple<int, int, int>> meshes;
  for (const ChainMesh& mesh : chain.chain.meshes)
    meshes.emplace_back(counted(mesh.tail), counted(mesh.head), counted(mesh.carrier));
  return py::make_tuple(chain.number.toString(), axes, meshes);
}

py::list chainsOf(std::optional<int> links, int dof, std::optional<int> axes, bool onlyNonfractionated) {
  py::list rows;
  for (const AtlasChain& each : Atlas::shipped().chains()) {
    if ((links && each.number.links != *links) || each.number.dof != dof) continue;
    if (axes && each.chain.axes.size() != static_cast<std::size_t>(*axes)) continue;
    if (onlyNonfractionated && !isNonfractionated(each.chain)) continue;
    rows.append(chainRow(each));
  }
  return rows;
}

/// A document of the chain; std::nullopt if the atlas has none of this number.
std::optional<Document> chainNumbered(const std::string& text, std::optional<int> frame) {
  const auto number = ChainNumber::fromText(text);
  const AtlasChain* const chain =
      number && number->displacement > 0 ? Atlas::shipped().find(*number) : nullptr;
  if (chain == nullptr) return std::nullopt;
  if (frame && (*frame < 1 || *frame > chain->chain.links))
    throw py::index_error("The chain has no such link.");
  ChainDrawing drawing;
  if (frame) drawing.frame = *frame - 1;
  Mechanism made = interruptible(
      [&](const std::stop_token& stop) { return chainDocument(chain->chain, text, drawing, stop); });
  return edited(std::move(made));
}

/// The links that were left out with the reasons, and the chains: labels of links and meshes, freedom,
/// whether it is locked, the numbers of its rotation graph and its displacement graph.
py::tuple identityOf(const Document& document) {
  const Mechanism& mechanism = document.mechanism();
  if (mechanism.links.size() > kMaxIdentifiedLinks)
    throw py::value_error("Trains of more than 2,000 links are not identified.");
  const Placement placement = placementOf(mechanism);
  const DrawnChain drawn = valueOrRaise(drawnChain(mechanism, placement));
  const auto identity = interruptible([&](const std::stop_token& stop) {
    return identifyTrain(mechanism, placement, drawn, Atlas::shipped(), stop);
  });
  py::list removed;
  py::list chains;
  if (!identity) return py::make_tuple(removed, chains);
  for (const RemovedLink& each : identity->removed)
    removed.append(py::make_tuple(mechanism.linkLabel(each.link), std::string(removalName(each.why))));
  const auto text = [](const std::optional<ChainNumber>& number) {
    return number ? std::optional(number->toString()) : std::nullopt;
  };
  for (const IdentifiedChain& part : identity->parts) {
    std::vector<int> links;
    for (const int each : part.links) links.push_back(mechanism.linkLabel(each));
    std::vector<int> meshes;
    for (const int each : part.meshes) meshes.push_back(mechanism.meshLabel(each));
    chains.append(
        py::make_tuple(links, meshes, part.dof, part.isLocked, text(part.rotation), text(part.displacement)));
  }
  return py::make_tuple(removed, chains);
}

}  // namespace

void addDesign(py::module_& module) {
  module.def("gearbox", gearboxesFor);
  module.def("hardware", hubsFor);
  module.def("atlas", chainsOf);
  module.def("atlas_document", chainNumbered);
  py::class_<Document>(module.attr("Document")).def("identify", identityOf);
}

}  // namespace geargraph::python
