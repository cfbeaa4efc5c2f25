#include "core/presentation/result_json/kinematics_json.h"

#include <span>

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

void writeNumber(JsonWriter& json, int value) {
  json.number(static_cast<std::int64_t>(value));
}

void writeLabels(JsonWriter& json, std::string_view name, const Digraph& graph, std::span<const int> joints) {
  json.key(name);
  json.beginArray(Layout::row);
  for (const JointOrdinal joint : joints) writeNumber(json, graph.edgeLabel(joint));
  json.endArray();
}

/// A matrix row by row; writeEntry(row, column).
template <class WriteEntry>
void writeRows(JsonWriter& json, std::string_view name, std::size_t rows, std::size_t columns,
               const WriteEntry& writeEntry) {
  json.key(name);
  json.beginArray();
  for (std::size_t row = 0; row < rows; ++row) {
    json.beginArray(Layout::row);
    for (std::size_t column = 0; column < columns; ++column) writeEntry(row, column);
    json.endArray();
  }
  json.endArray();
}

void writeNull(JsonWriter& json, std::string_view name) {
  json.key(name);
  json.null();
}

void writeSymbol(JsonWriter& json, const std::optional<RationalFunction>& entry) {
  if (entry) {
    json.string(entry->toText());
  } else {
    json.null();
  }
}

/// The links of a mesh's path through the tree, and the levels it meets, each once a stretch.
struct Path {
  std::vector<int> nodes;
  std::vector<int> word;
};

Path pathOf(const TtGraph& graph, MeshOrdinal mesh) {
  const DigraphEdge& edge = graph.graph().meshEdge(mesh);
  Path path{{edge.tail}, {}};
  for (const PathStep& step : treePath(graph.tree(), edge.tail, edge.head)) {
    const DigraphEdge& joint = graph.graph().turningEdge(step.joint);
    path.nodes.push_back(joint.tail == path.nodes.back() ? joint.head : joint.tail);
    const int level = graph.levels().ofJoint[step.joint];
    if (path.word.empty() || path.word.back() != level) path.word.push_back(level);
  }
  return path;
}

void writeTransferVertex(JsonWriter& json, const AnalysisSnapshot& snapshot, MeshOrdinal mesh) {
  const TtGraph& graph = *snapshot.kinematics->ttGraph;
  const Path path = pathOf(graph, mesh);
  const auto& vertex = graph.transferVertices().ofMesh[mesh];
  const auto& terminal = graph.terminal(mesh);
  json.beginObject(Layout::row);
  json.member("mesh", graph.graph().edgeLabel(graph.graph().t() + mesh));
  json.key("carrier");
  if (vertex) {
    writeNumber(json, graph.graph().nodeLabel(vertex->carrier));
  } else {
    json.null();
  }
  json.key("path");
  json.beginArray();
  for (const LinkOrdinal node : path.nodes) writeNumber(json, graph.graph().nodeLabel(node));
  json.endArray();
  json.key("axes");
  json.beginArray();
  for (const int level : path.word) json.string(graph.levels().name(level));
  json.endArray();
  json.key("sign");
  if (terminal) {
    writeNumber(json, terminal->sign);
  } else {
    json.null();
  }
  json.endObject();
}

}  // namespace

void writeTransferVertices(JsonWriter& json, const AnalysisSnapshot& snapshot) {
  if (!snapshot.kinematics) return json.null();
  json.beginArray();
  for (MeshOrdinal mesh = 0; mesh < snapshot.graph->c(); ++mesh) writeTransferVertex(json, snapshot, mesh);
  json.endArray();
}

void writeCouplingRows(JsonWriter& json, const AnalysisSnapshot& snapshot) {
  if (!snapshot.kinematics || !snapshot.kinematics->model) return json.null();
  const auto& held = snapshot.kinematics->model->held();
  const int joints = snapshot.graph->t();
  json.beginObject();
  json.key("rows");
  json.beginArray(Layout::row);
  for (const auto& row : held) json.string(snapshot.mechanism->couplings[row.coupling].id.text());
  json.endArray();
  json.key("columns");
  json.beginArray(Layout::row);
  for (JointOrdinal joint = 0; joint < joints; ++joint) writeNumber(json, snapshot.graph->edgeLabel(joint));
  json.endArray();
  writeRows(json, "entries", held.size(), static_cast<std::size_t>(joints), [&](auto row, auto column) {
    int factor = 0;
    for (const auto& term : held[row].joints)
      if (term.of == static_cast<int>(column)) factor = term.factor;
    writeNumber(json, factor);
  });
  json.endObject();
}

template <class Solution>
void writeMatroidMatrices(JsonWriter& json, const AnalysisSnapshot& snapshot, const Solution& exact) {
  const std::size_t rows = exact.outputs.size();
  const std::size_t columns = exact.inputs.size();
  json.beginObject();
  writeLabels(json, "inputs", *snapshot.graph, exact.inputs);
  writeLabels(json, "outputs", *snapshot.graph, exact.outputs);
  if (exact.matrix.size() == rows * columns) {
    const auto at = [&](std::size_t row, std::size_t column) -> const auto& {
      return exact.matrix[row * columns + column];
    };
    writeRows(json, "exact", rows, columns,
              [&](auto row, auto column) { json.string(at(row, column).toString()); });
    writeRows(json, "numeric", rows, columns,
              [&](auto row, auto column) { json.numberOrNull(at(row, column).toDouble()); });
  } else {
    writeNull(json, "exact");
    const std::vector<double>& live = snapshot.matroid()->solution->matrix;
    if (live.size() == rows * columns) {
      writeRows(json, "numeric", rows, columns,
                [&](auto row, auto column) { json.number(live[row * columns + column]); });
    } else {
      writeNull(json, "numeric");
    }
  }
  if (snapshot.solved->symbolic) {
    const auto& symbols = snapshot.solved->symbolic->matrix;
    writeRows(json, "symbolic", rows, columns,
              [&](auto row, auto column) { writeSymbol(json, symbols[row * columns + column]); });
  } else {
    writeNull(json, "symbolic");
  }
  json.endObject();
}

void writeMatroidSolution(JsonWriter& json, const AnalysisSnapshot& snapshot) {
  if (!snapshot.solved) return json.null();
  if (snapshot.solved->pi) return writeMatroidMatrices(json, snapshot, *snapshot.solved->pi);
  if (!snapshot.solved->exact) return json.null();
  writeMatroidMatrices(json, snapshot, *snapshot.solved->exact);
}

template <class Value>
void writeTtMatrices(JsonWriter& json, const AnalysisSnapshot& snapshot, const RateMatrix<Value>& exact) {
  const std::size_t rows = exact.outputs.size();
  const std::size_t columns = exact.inputs.size();
  json.beginObject();
  writeLabels(json, "inputs", *snapshot.graph, exact.inputs);
  writeLabels(json, "outputs", *snapshot.graph, exact.outputs);
  writeRows(json, "exact", rows, columns,
            [&](auto row, auto column) { json.string(exact.entries[row][column].toString()); });
  if (snapshot.solved->ttSymbolic) {
    const auto& symbols = snapshot.solved->ttSymbolic->entries;
    writeRows(json, "symbolic", rows, columns,
              [&](auto row, auto column) { writeSymbol(json, symbols[row][column]); });
  } else {
    writeNull(json, "symbolic");
  }
  json.endObject();
}

void writeTtSolution(JsonWriter& json, const AnalysisSnapshot& snapshot) {
  if (!snapshot.solved) return json.null();
  if (snapshot.solved->ttPi) return writeTtMatrices(json, snapshot, *snapshot.solved->ttPi);
  if (!snapshot.solved->ttExact) return json.null();
  writeTtMatrices(json, snapshot, *snapshot.solved->ttExact);
}

void writeAgreement(JsonWriter& json, const AnalysisSnapshot& snapshot) {
  if (!snapshot.solved || !snapshot.solved->agreement) return json.null();
  json.beginObject(Layout::row);
  json.member("equal", snapshot.solved->agreement->equal);
  json.member("largestDifference", snapshot.solved->agreement->largestDifference.toString());
  json.endObject();
}

void writeJointSpeeds(JsonWriter& json, const AnalysisSnapshot& snapshot) {
  if (!snapshot.solved || (!snapshot.solved->exact && !snapshot.solved->pi)) return json.null();
  json.beginObject(Layout::row);
  for (JointOrdinal joint = 0; joint < snapshot.graph->t(); ++joint) {
    json.member(std::to_string(snapshot.graph->edgeLabel(joint)),
                snapshot.solved->pi ? snapshot.solved->pi->rates[joint].toString()
                                    : snapshot.solved->exact->rates[joint].toString());
  }
  json.endObject();
}

void writeLinkVelocities(JsonWriter& json, const AnalysisSnapshot& snapshot) {
  if (!snapshot.solved || snapshot.matroid() == nullptr) return json.null();
  const std::vector<Vector3>& velocities = snapshot.matroid()->linkVelocities;
  json.beginObject();
  for (LinkOrdinal node = 1; node < snapshot.graph->nodeCount(); ++node) {
    json.key(std::to_string(snapshot.graph->nodeLabel(node)));
    json.beginArray(Layout::row);
    for (const double component : velocities[static_cast<std::size_t>(node)]) json.number(component);
    json.endArray();
  }
  json.endObject();
}

}  // namespace geargraph
