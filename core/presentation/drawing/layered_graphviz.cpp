#include <graphviz/gvc.h>

#include <mutex>
#include <string>

#include "core/presentation/drawing/layered_places.h"

namespace geargraph {
namespace {

constexpr double kHalf = 72;  ///< points, from a column or row to half the way to the next

/// Graphviz' functions take `char*` and do not write to it.
char* text(const char* constant) {
  return const_cast<char*>(constant);  // NOLINT(cppcoreguidelines-pro-type-const-cast)
}

/// Graphviz keeps state of its own for the whole process: one call at a time. Numbers are handed over as
/// whole numbers only, because it reads decimals by the locale of the process.
class Graphviz {
 public:
  Graphviz() : m_lock(mutex()), m_graph(agopen(text("digraph"), Agdirected, nullptr)) {
    static_cast<void>(agseterr(AGMAX));  // a failure is answered, not printed
    set(AGRAPH, "rankdir", "LR");
    set(AGRAPH, "splines", "none");
    set(AGRAPH, "nodesep", "1");
    set(AGRAPH, "ranksep", "1");
    set(AGNODE, "shape", "circle");
    set(AGNODE, "label", "");
    set(AGNODE, "width", "1");
    set(AGNODE, "height", "1");
    m_constraint = set(AGEDGE, "constraint", "true");
    m_weight = set(AGEDGE, "weight", "1");
  }
  Graphviz(const Graphviz&) = delete;
  Graphviz& operator=(const Graphviz&) = delete;
  ~Graphviz() {
    if (m_laidOut) gvFreeLayout(context(), m_graph);
    agclose(m_graph);
  }

  void addNode() {
    const std::string name = "n" + std::to_string(m_nodes.size());
    m_nodes.push_back(agnode(m_graph, text(name.c_str()), 1));
  }
  void addEdge(int tail, int head, bool isMesh) {
    Agedge_t* edge = agedge(m_graph, m_nodes[static_cast<std::size_t>(tail)],
                            m_nodes[static_cast<std::size_t>(head)], nullptr, 1);
    agxset(edge, m_constraint, text(isMesh ? "false" : "true"));
    agxset(edge, m_weight, text(isMesh ? "1" : "4"));
  }
  bool layout() {
    m_laidOut = gvLayout(context(), m_graph, "dot") == 0;
    return m_laidOut;
  }
  /// In half columns and rows, which are 2 inches apart with the settings above; y up.
  [[nodiscard]] CanvasPoint place(int node) const {
    const pointf at = ND_coord(m_nodes[static_cast<std::size_t>(node)]);
    return {at.x / kHalf, at.y / kHalf};
  }

 private:
  Agsym_t* set(int kind, const char* name, const char* value) {
    return agattr(m_graph, kind, text(name), text(value));
  }
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }
  static GVC_t* context() {
    static GVC_t* const instance = gvContext();  // loading the plugins once
    return instance;
  }

  std::lock_guard<std::mutex> m_lock;
  Agraph_t* m_graph;
  Agsym_t* m_constraint = nullptr;
  Agsym_t* m_weight = nullptr;
  std::vector<Agnode_t*> m_nodes;
  bool m_laidOut = false;
};

}  // namespace

std::optional<std::vector<CanvasPoint>> layeredPlaces(int count, std::span<const LayeredEdge> edges) {
  Graphviz graphviz;
  for (int node = 0; node < count; ++node) graphviz.addNode();
  for (const LayeredEdge& edge : edges) graphviz.addEdge(edge.tail, edge.head, edge.isMesh);
  if (!graphviz.layout()) return std::nullopt;
  std::vector<CanvasPoint> places;
  for (int node = 0; node < count; ++node) places.push_back(graphviz.place(node));
  return places;
}

}  // namespace geargraph
