#include "core/design/atlas/chain_form.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/design/atlas/canonical_graph.h"

namespace geargraph {
namespace {

enum VertexColour { kLinkColour = 0, kAxisColour = 1, kMeshColour = 1, kCarrierColour = 2, kAgainColour = 2 };

/// A vertex per link and per axis, an edge per link on an axis; a gear pair is an edge between two
/// links. A second one between the same links is a vertex joined to both.
ColouredGraph displacementGraph(const Chain& chain) {
  ColouredGraph graph;
  graph.colours.assign(static_cast<std::size_t>(chain.links), kLinkColour);
  for (const std::vector<int>& axis : chain.axes) {
    const int vertex = static_cast<int>(graph.colours.size());
    graph.colours.push_back(kAxisColour);
    for (const int link : axis) graph.edges.emplace_back(link, vertex);
  }
  std::set<std::pair<int, int>> pairs;
  for (const ChainMesh& mesh : chain.meshes) {
    if (pairs.insert(std::minmax(mesh.tail, mesh.head)).second) {
      graph.edges.emplace_back(mesh.tail, mesh.head);
      continue;
    }
    const int vertex = static_cast<int>(graph.colours.size());
    graph.colours.push_back(kAgainColour);
    graph.edges.insert(graph.edges.end(), {{vertex, mesh.tail}, {vertex, mesh.head}});
  }
  return graph;
}

/// A vertex per link; per gear pair a vertex joined to both gears and to one more that is joined to the
/// carrier.
ColouredGraph rotationGraph(const Chain& chain) {
  ColouredGraph graph;
  graph.colours.assign(static_cast<std::size_t>(chain.links), kLinkColour);
  for (const ChainMesh& mesh : chain.meshes) {
    const int pair = static_cast<int>(graph.colours.size());
    graph.colours.insert(graph.colours.end(), {kMeshColour, kCarrierColour});
    graph.edges.insert(graph.edges.end(),
                       {{pair, mesh.tail}, {pair, mesh.head}, {pair, pair + 1}, {pair + 1, mesh.carrier}});
  }
  return graph;
}

ColouredGraph comparedGraph(const Chain& chain, ChainLikeness likeness) {
  return likeness == ChainLikeness::displacement ? displacementGraph(chain) : rotationGraph(chain);
}

}  // namespace

ChainForm displacementForm(const Chain& chain) {
  return canonicalGraph(displacementGraph(chain)).form;
}

ChainForm rotationForm(const Chain& chain) {
  return canonicalGraph(rotationGraph(chain)).form;
}

std::vector<int> linkOrbits(const Chain& chain) {
  std::vector<int> orbits = canonicalGraph(displacementGraph(chain)).orbits;
  orbits.resize(static_cast<std::size_t>(chain.links));
  return orbits;
}

std::optional<std::vector<int>> isomorphism(const Chain& a, const Chain& b, ChainLikeness likeness) {
  const CanonicalGraph first = canonicalGraph(comparedGraph(a, likeness));
  const CanonicalGraph second = canonicalGraph(comparedGraph(b, likeness));
  if (a.links != b.links || first.form != second.form) return std::nullopt;
  std::vector<int> image(static_cast<std::size_t>(a.links));
  for (std::size_t i = 0; i < first.order.size(); ++i)
    if (first.order[i] < a.links) image[static_cast<std::size_t>(first.order[i])] = second.order[i];
  return image;
}

}  // namespace geargraph
