#include "core/presentation/result_json/analysis_json.h"

#include <vector>

#include "core/foundations/files/json_writer.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/presentation/result_json/diagnostics_json.h"
#include "core/presentation/result_json/kinematics_json.h"
#include "core/teaching/derivation/named_results.h"
#include "core/teaching/derivation/result_text.h"

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

/// Writes the parts of one analysis, a function a part.
class AnalysisJson {
 public:
  AnalysisJson(ByteSink& sink, const SnapshotPtr& snapshot, const AnalysisJsonOptions& options)
      : m_json(sink), m_snapshot(snapshot), m_options(options) {}

  void write(const Diagnostics& diagnostics) {
    m_json.beginObject();
    m_json.member("format", "geargraph-analysis");
    m_json.member("version", 1);
    part("counts", m_snapshot != nullptr, &AnalysisJson::counts);
    if (m_snapshot != nullptr) engagement(m_snapshot->mechanism->engaged);
    part("labels", m_snapshot != nullptr, &AnalysisJson::labels);
    if (m_options.matrices) {
      part("matrices", m_snapshot != nullptr, &AnalysisJson::matrices);
      part("cycles", m_snapshot != nullptr && m_snapshot->tree, &AnalysisJson::cycles);
    }
    if (m_snapshot != nullptr && !m_snapshot->mechanism->engaged.empty())
      motion("couplingRows", writeCouplingRows);
    motion("transferVertices", writeTransferVertices);
    motion("solution", writeMatroidSolution);
    motion("ttSolution", writeTtSolution);
    motion("agreement", writeAgreement);
    motion("jointSpeeds", writeJointSpeeds);
    motion("linkVelocities", writeLinkVelocities);
    m_json.key("diagnostics");
    writeDiagnostics(m_json, diagnostics);
    m_json.endObject();
  }

 private:
  /// A member that is null where it is not defined.
  void part(std::string_view name, bool isDefined, void (AnalysisJson::*writePart)()) {
    m_json.key(name);
    if (isDefined) {
      (this->*writePart)();
    } else {
      m_json.null();
    }
  }

  /// A member that says itself whether it is defined.
  void motion(std::string_view name, void (*writePart)(JsonWriter&, const AnalysisSnapshot&)) {
    m_json.key(name);
    if (m_snapshot != nullptr) {
      writePart(m_json, *m_snapshot);
    } else {
      m_json.null();
    }
  }

  void counts() {
    const Mechanism& m = *m_snapshot->mechanism;
    m_json.beginObject(Layout::row);
    m_json.member("links", m.n());
    m_json.member("turningJoints", m.t());
    m_json.member("gearMeshes", m.c());
    const MatroidAnalysis* matroid = m_snapshot->matroid();
    count("rank", matroid != nullptr ? std::optional(matroid->rank) : std::nullopt);
    count("dof", matroid != nullptr ? std::optional(matroid->dof) : std::nullopt);
    m_json.member("kutzbachDof", 6 * m.n() - 5 * m.t() - m.c());
    m_json.endObject();
  }

  /// "state" and "engaged", only where something is.
  void engagement(const std::vector<ShiftElementId>& engaged) {
    if (engaged.empty()) return;
    m_json.key("state");
    const int state = engagedState(*m_snapshot->mechanism);
    if (state < 0) {
      m_json.null();
    } else {
      m_json.string(m_snapshot->mechanism->states[static_cast<std::size_t>(state)].name);
    }
    m_json.key("engaged");
    m_json.beginArray(Layout::row);
    for (const ShiftElementId id : engaged) m_json.string(id.text());
    m_json.endArray();
  }

  void count(std::string_view name, std::optional<int> value) {
    m_json.key(name);
    if (value) {
      number(*value);
    } else {
      m_json.null();
    }
  }

  void labels() {
    const Mechanism& m = *m_snapshot->mechanism;
    m_json.beginObject();
    labelsOf("links", m.links, m.linkLabel(0));
    labelsOf("turningJoints", m.turningJoints, m.jointLabel(0));
    labelsOf("gearMeshes", m.gearMeshes, m.meshLabel(0));
    m_json.endObject();
  }

  template <class Element>
  void labelsOf(std::string_view name, const std::vector<Element>& elements, int first) {
    m_json.key(name);
    m_json.beginObject(Layout::row);
    for (const Element& element : elements) m_json.member(element.id.text(), first++);
    m_json.endObject();
  }

  void matrices() {
    m_json.beginObject();
    const ResultSource source{m_snapshot};
    for (const NamedResult* result : namedResults()) {
      if (result->jsonName.empty()) continue;
      m_json.key(result->jsonName);
      ResultTablePtr table = resultTable(*result, source, EntryForm::decimals);
      if (!table) table = exactTable(*result, source);
      if (table) {
        writeResultJson(m_json, *table, isTooLarge(table->rows(), table->columns()));
      } else {
        m_json.null();
      }
    }
    m_json.endObject();
  }

  /// Too large to be written with all its zeros.
  [[nodiscard]] bool isTooLarge(int rows, int columns) const {
    return !m_options.dense && static_cast<long long>(rows) * columns > kMaxEntries;
  }

  /// The fundamental cycles: the rows of T, in the order of its columns.
  void cycles() {
    const IntegerMatrix& tree = *m_snapshot->matrix(MatrixKind::spanningTree);
    m_json.beginArray();
    for (int row = 0; row < tree.rows(); ++row) {
      tree.rowEntries(row, m_entries);
      m_json.beginObject(Layout::row);
      m_json.member("mesh", tree.rowHeading(row).label);
      m_json.key("joints");
      m_json.beginArray();
      for (const MatrixEntry& entry : m_entries) number(tree.columnHeading(entry.column).label);
      m_json.endArray();
      m_json.key("signs");
      m_json.beginArray();
      for (const MatrixEntry& entry : m_entries) number(entry.value);
      m_json.endArray();
      m_json.endObject();
    }
    m_json.endArray();
  }

  void number(int value) { m_json.number(static_cast<std::int64_t>(value)); }

  JsonWriter m_json;
  SnapshotPtr m_snapshot;
  AnalysisJsonOptions m_options;
  std::vector<MatrixEntry> m_entries;  ///< of the row at hand
};

}  // namespace

void writeAnalysisJson(ByteSink& sink, const SnapshotPtr& snapshot, const Diagnostics& diagnostics,
                       const AnalysisJsonOptions& options) {
  AnalysisJson(sink, snapshot, options).write(diagnostics);
}

}  // namespace geargraph
