#include "core/presentation/results/states_json.h"

#include "core/foundations/files/json_writer.h"
#include "core/presentation/results/diagnostics_json.h"

namespace geargraph::inline results {
namespace {

using Layout = JsonWriter::Layout;

class StatesJson {
 public:
  StatesJson(JsonWriter& json, const AnalysisSnapshot& snapshot) : m_json(json), m_snapshot(snapshot) {}

  void write(const StateSolution& solution) {
    const ShiftState& state = m_snapshot.mechanism->states[static_cast<std::size_t>(solution.state)];
    m_json.beginObject();
    m_json.member("name", state.name);
    m_json.key("engaged");
    m_json.beginArray(Layout::row);
    for (const CouplingId coupling : state.engaged) m_json.string(coupling.text());
    m_json.endArray();
    writeDof(solution);
    writeRatio(solution);
    writeSpeeds(solution);
    m_json.key("diagnostics");
    writeDiagnostics(m_json, solution.diagnostics);
    m_json.endObject();
  }

 private:
  void writeDof(const StateSolution& solution) {
    m_json.key("dof");
    if (hasErrors(solution.diagnostics)) return m_json.null();
    m_json.number(static_cast<std::int64_t>(solution.dof));
  }

  void writeRatio(const StateSolution& solution) {
    m_json.key("ratio");
    solution.ratio ? m_json.string(solution.ratio->toString()) : m_json.null();
    m_json.key("ratioNumeric");
    solution.ratio ? m_json.numberOrNull(solution.ratio->toDouble()) : m_json.null();
    m_json.key("ratioSymbolic");
    solution.symbolicRatio ? m_json.string(solution.symbolicRatio->toText()) : m_json.null();
  }

  void writeSpeeds(const StateSolution& solution) {
    m_json.key("jointSpeeds");
    if (!solution.isSolved()) return m_json.null();
    m_json.beginObject(Layout::row);
    for (std::size_t joint = 0; joint < solution.rates.size(); ++joint) {
      m_json.member(std::to_string(m_snapshot.graph->edgeLabel(static_cast<int>(joint))),
                    solution.rates[joint].toString());
    }
    m_json.endObject();
  }

  JsonWriter& m_json;
  const AnalysisSnapshot& m_snapshot;
};

}  // namespace

std::string statesJson(const AnalysisSnapshot* snapshot) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-states");
    json.member("version", 1);
    json.key("states");
    if (snapshot != nullptr && (snapshot->states || snapshot->mechanism->states.empty())) {
      json.beginArray();
      if (snapshot->states) {
        for (const StateSolution& solution : *snapshot->states) StatesJson(json, *snapshot).write(solution);
      }
      json.endArray();
    } else {
      json.null();
    }
    json.endObject();
  }
  return sink.take();
}

}  // namespace geargraph::inline results
