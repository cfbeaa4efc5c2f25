#include "core/presentation/result_json/states_json.h"

#include <algorithm>

#include "core/foundations/files/json_writer.h"
#include "core/mechanism/model/load_edits.h"
#include "core/presentation/result_json/diagnostics_json.h"

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

class StatesJson {
 public:
  StatesJson(JsonWriter& json, const AnalysisSnapshot& snapshot) : m_json(json), m_snapshot(snapshot) {}

  /// `torques` may be null.
  void write(const StateSolution& solution, const StateForces* torques) {
    const ShiftState& state = m_snapshot.mechanism->states[static_cast<std::size_t>(solution.state)];
    m_json.beginObject();
    m_json.member("name", state.name);
    m_json.key("engaged");
    m_json.beginArray(Layout::row);
    for (const ShiftElementId coupling : state.engaged) m_json.string(coupling.text());
    m_json.endArray();
    writeFreewheels(solution);
    writeDof(solution);
    writeRatio(solution);
    writeSpeeds(solution);
    const bool isSolved = torques != nullptr && torques->report;
    writeTorques(isSolved && torques->report->isAnswered() ? &*torques->report : nullptr);
    writeEfficiencies(isSolved ? &torques->ofEfficiency() : nullptr);
    m_json.key("diagnostics");
    writeDiagnostics(m_json, solution.diagnostics);
    m_json.endObject();
  }

 private:
  /// Only of documents that have some.
  void writeFreewheels(const StateSolution& solution) {
    const auto& couplings = m_snapshot.mechanism->couplings;
    if (std::none_of(couplings.begin(), couplings.end(),
                     [](const ShiftElement& each) { return each.kind == ShiftElementKind::freewheel; }))
      return;
    m_json.key("freewheels");
    m_json.beginObject(Layout::row);
    for (const StateSolution::Freewheel& each : solution.freewheels)
      m_json.member(couplings[each.coupling].id.text(), std::string_view(each.isLocked ? "locked" : "free"));
    m_json.endObject();
  }

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
      m_json.key(std::to_string(m_snapshot.graph->edgeLabel(static_cast<int>(joint))));
      solution.isIdle(static_cast<int>(joint)) ? m_json.null()
                                               : m_json.string(solution.rates[joint].toString());
    }
    m_json.endObject();
  }

  void member(std::string_view name, const std::optional<Real>& value) {
    m_json.key(name);
    if (!value) return m_json.null();
    value->isExact() ? m_json.string(value->fraction()->toString()) : m_json.numberOrNull(value->number());
  }

  /// null where the torques are not known, or the state has no two ends.
  void writeTorques(const StaticsReport* report) {
    m_json.key("torques");
    const auto ends = report == nullptr ? std::nullopt : endTorques(*m_snapshot.mechanism, *report);
    if (!ends) return m_json.null();
    m_json.beginObject(Layout::row);
    member("drive", ends->drive);
    member("driven", ends->driven);
    m_json.key("couplings");
    m_json.beginObject(Layout::row);
    const StaticsSolution& solution = report->solution();
    for (std::size_t part = 0; part < report->held.size(); ++part) {
      const HeldPart& held = report->held[part];
      if (held.coupling < 0 || !held.isMain) continue;
      const auto unknown = static_cast<std::size_t>(m_snapshot.mechanism->c()) + part;
      member(m_snapshot.mechanism->couplings[held.coupling].id.text(),
             solution.determined[unknown] != 0 ? std::optional(solution.values[unknown]) : std::nullopt);
    }
    m_json.endObject();
    places("otherLoads", ends->otherLoads);
    places("leftOut", report->leftOut);
    m_json.endObject();
  }

  /// As on the command line: "joint:14", "link:3".
  void places(std::string_view name, const std::vector<Load>& loads) {
    m_json.key(name);
    m_json.beginArray(Layout::row);
    for (const Load& load : loads) {
      if (const auto joint = jointOf(load)) {
        m_json.string("joint:" + labelOf(*m_snapshot.mechanism, *joint).value_or(joint->text()));
      } else {
        const LinkId link = *linkOf(load);
        m_json.string("link:" + labelOf(*m_snapshot.mechanism, link).value_or(link.text()));
      }
    }
    m_json.endArray();
  }

  void writeEfficiencies(const StaticsReport* report) {
    const auto write = [&](std::string_view name, std::string_view locking,
                           const std::optional<LossySolution>& solution,
                           const std::optional<PowerSums>& sums) {
      const bool isSolved = solution && solution->outcome == LossySolution::Outcome::solved;
      member(name, isSolved && sums ? sums->efficiency() : std::nullopt);
      m_json.member(locking, solution && solution->outcome == LossySolution::Outcome::selfLocking);
    };
    const StaticsReport none;
    const StaticsReport& of = report == nullptr ? none : *report;
    write("efficiency", "selfLocking", of.lossy, of.sums);
    write("efficiencyBackward", "selfLockingBackward", of.backward, of.backwardSums);
  }

  JsonWriter& m_json;
  const AnalysisSnapshot& m_snapshot;
};

}  // namespace

std::string statesJson(const AnalysisSnapshot* snapshot, std::span<const StateForces> torques) {
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
        for (std::size_t state = 0; state < snapshot->states->size(); ++state)
          StatesJson(json, *snapshot)
              .write((*snapshot->states)[state], state < torques.size() ? &torques[state] : nullptr);
      }
      json.endArray();
    } else {
      json.null();
    }
    json.endObject();
  }
  return sink.take();
}

}  // namespace geargraph
