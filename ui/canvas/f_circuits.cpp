#include "ui/canvas/f_circuits.h"

#include <QCoreApplication>

#include "core/presentation/drawing/tt_graph_drawing.h"
#include "core/theory/ttgraph/mesh_words.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("canvas", text);
}

QString numbered(const std::string& equation, int number) {
  const QString text = QString::fromStdString(equation);
  return number > 0 ? text + QStringLiteral("   (%1)").arg(number) : text;
}

}  // namespace

std::optional<FCircuits> fCircuits(const TtGraph& graph, int mesh) {
  const std::optional<MeshWords> words = meshWords(graph, mesh);
  if (!words) return std::nullopt;
  const Digraph& digraph = graph.graph();
  const DigraphEdge& edge = digraph.meshEdge(mesh);
  const TransferVertex& vertex = *graph.transferVertices().ofMesh[static_cast<std::size_t>(mesh)];
  FCircuits circuits;
  circuits.emphases[digraph.edgeId(digraph.t() + mesh)].walk = 1;
  circuits.emphases[digraph.nodeId(vertex.carrier)].hovered = true;
  // A step along the joint runs from its tail to its head, against the branch; the walk comes back over it.
  for (const bool second : {false, true}) {
    for (const PathStep& step : treePath(graph.tree(), second ? edge.head : edge.tail, vertex.carrier)) {
      circuits.emphases[digraph.edgeId(step.joint)] = {.walk = step.direction, .second = second};
    }
  }
  circuits.caption << tr("%1:  %2,  transfer vertex %3")
                          .arg(QString::fromStdString(words->set), QString::fromStdString(words->path))
                          .arg(vertex.carrier);
  circuits.colors.push_back(ColorRole::ink);
  if (words->terminal.empty()) {
    circuits.caption << tr("The drawn pose does not tell the sign of its terminal equation.");
    circuits.colors.push_back(ColorRole::secondary);
    return circuits;
  }
  circuits.caption << numbered(words->terminal, words->terminalNumber);
  circuits.colors.push_back(ColorRole::ink);
  if (words->tailCircuit.empty()) return circuits;
  circuits.caption << numbered(words->tailCircuit, words->tailNumber)
                   << numbered(words->headCircuit, words->headNumber);
  circuits.colors.insert(circuits.colors.end(), {ColorRole::accent, kSecondWalk});
  return circuits;
}

}  // namespace geargraph
