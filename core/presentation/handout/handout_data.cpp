#include "core/presentation/handout/handout_data.h"

#include <cmath>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/rational.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/json_writer.h"
#include "core/mechanism/model/shift_edits.h"
#include "core/presentation/handout/page_scene.h"
#include "core/presentation/handout/script_texts.h"
#include "core/teaching/derivation/cell_explanation.h"
#include "core/theory/matroid/coefficient_matrix.h"
#include "core/theory/pose/joint_limits.h"
#include "core/theory/pose/turning_lines.h"
#include "core/theory/states/state_edits.h"

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

class DataWriter {
 public:
  DataWriter(ByteSink& sink, const AnalysisSnapshot& snapshot)
      : m_json(sink), m_snapshot(snapshot), m_mechanism(*snapshot.mechanism), m_graph(*snapshot.graph) {}

  void write(const MechanismScene* stage, double tolerance, const HandoutLevers& levers,
             const std::stop_token& stop) {
    m_json.beginObject();
    m_json.member("format", "geargraph-handout");
    m_json.member("version", 1);
    m_json.member("decimal", std::string(1, decimalSign()));
    writeTexts();
    writeElements();
    writeJoints();
    writeRows();
    writeInputs();
    writeStates(stop);
    writeHandoutLevers(m_json, m_snapshot, levers);
    if (stage != nullptr && m_snapshot.tree && m_snapshot.kinematics) {
      writeMovers();
      m_json.key("scene");
      writePageScene(m_json, *stage, m_graph, tolerance);
    }
    m_json.endObject();
  }

 private:
  void writeTexts() {
    m_json.key("texts");
    m_json.beginObject();
    for (const ScriptText& each : scriptTexts()) m_json.member(each.name, translated(each.text));
    m_json.endObject();
  }

  void writeElements() {
    m_json.key("elements");
    m_json.beginArray();
    for (LinkOrdinal link = 0; link <= m_mechanism.n(); ++link) {
      const std::string name = linkName(link);
      element(m_graph.nodeId(link), m_graph.nodeLabel(link), {name, name, linkLines(link)});
    }
    for (JointOrdinal joint = 0; joint < m_mechanism.t(); ++joint) {
      const DigraphEdge& edge = m_graph.turningEdge(joint);
      const std::string label = std::to_string(m_mechanism.jointLabel(joint));
      element(m_graph.edgeId(joint), m_mechanism.jointLabel(joint),
              {jointName(joint),
               translated("joint %1", {label}),
               {translated("From %1 to %2.", {linkName(edge.tail), linkName(edge.head)})}});
    }
    for (MeshOrdinal mesh = 0; mesh < m_mechanism.c(); ++mesh) {
      const std::string label = std::to_string(m_mechanism.meshLabel(mesh));
      element(m_graph.edgeId(m_mechanism.t() + mesh), m_mechanism.meshLabel(mesh),
              {translated("Mesh %1", {label}), translated("mesh %1", {label}), meshLines(mesh)}, mesh);
    }
    m_json.endArray();
  }

  /// What the page says of an element.
  struct Wording {
    std::string name;     ///< alone: "Joint 8"
    std::string mention;  ///< within a sentence: "joint 8"
    std::vector<std::string> lines;
  };

  void element(ElementId id, int label, const Wording& wording, MeshOrdinal mesh = -1) {
    m_json.beginObject(Layout::row);
    m_json.member("list", listName(id.kind));
    m_json.member("id", id.id.text());
    m_json.member("label", label);
    m_json.member("name", wording.name);
    m_json.member("mention", wording.mention);
    m_json.key("lines");
    m_json.beginArray(Layout::row);
    for (const std::string& line : wording.lines) m_json.string(line);
    m_json.endArray();
    if (mesh >= 0 && m_snapshot.tree) writeWalk(mesh);
    m_json.endObject();
  }

  [[nodiscard]] std::string keyOf(const ElementId& id) const {
    return std::string(listName(id.kind)) + "/" + id.id.text();
  }

  /// The row of C as a walk: along the mesh, then back to its tail through the tree [AU, Eq. (5)].
  void writeWalk(MeshOrdinal mesh) {
    m_json.key("walk");
    m_json.beginArray(Layout::row);
    int edge = m_mechanism.t() + mesh;
    int node = m_graph.meshEdge(mesh).tail;
    int direction = 1;
    const int end = node;
    const std::vector<PathStep> back = treePath(*m_snapshot.tree, m_graph.meshEdge(mesh).head, end);
    for (std::size_t at = 0; at <= back.size(); ++at) {
      if (at > 0) {
        edge = back[at - 1].joint;
        direction = back[at - 1].direction;
      }
      const DigraphEdge& arrow = m_graph.edge(edge);
      const int next = arrow.tail == node ? arrow.head : arrow.tail;
      m_json.beginArray(Layout::row);
      m_json.string(keyOf(m_graph.edgeId(edge)));
      m_json.number(static_cast<std::int64_t>(direction));
      m_json.string(stepText(edge, direction, nodeName(node), nodeName(next)));
      m_json.endArray();
      node = next;
    }
    m_json.endArray();
  }

  [[nodiscard]] std::string stepText(int edge, int direction, const std::string& from,
                                     const std::string& to) const {
    const std::string label = std::to_string(m_graph.edgeLabel(edge));
    const std::string entry(printedEntry(direction));
    if (edge < m_mechanism.t()) {
      return direction > 0 ? translated("Along joint %1, from %2 to %3: %4.", {label, from, to, entry})
                           : translated("Against joint %1, from %2 to %3: %4.", {label, from, to, entry});
    }
    return direction > 0 ? translated("Along mesh %1, from %2 to %3: %4.", {label, from, to, entry})
                         : translated("Against mesh %1, from %2 to %3: %4.", {label, from, to, entry});
  }

  [[nodiscard]] std::string nodeName(LinkOrdinal link) const {
    return link == 0 ? translated("the ground")
                     : translated("link %1", {std::to_string(m_mechanism.linkLabel(link))});
  }

  [[nodiscard]] std::string linkName(LinkOrdinal link) const {
    const std::string& name = m_mechanism.links[link].name;
    if (link == 0 || name.empty()) return nodeName(link);
    return translated("link %1 (%2)", {std::to_string(m_mechanism.linkLabel(link)), name});
  }
  [[nodiscard]] std::string jointName(JointOrdinal joint) const {
    return translated("Joint %1", {std::to_string(m_mechanism.jointLabel(joint))});
  }

  [[nodiscard]] std::vector<std::string> linkLines(LinkOrdinal link) const {
    std::vector<std::string> joints;
    for (const JointOrdinal joint : m_graph.turningEdgesAt(link))
      joints.push_back(std::to_string(m_mechanism.jointLabel(joint)));
    std::vector<std::string> meshes;
    for (MeshOrdinal mesh = 0; mesh < m_mechanism.c(); ++mesh) {
      const DigraphEdge& edge = m_graph.meshEdge(mesh);
      if (edge.tail == link || edge.head == link)
        meshes.push_back(std::to_string(m_mechanism.meshLabel(mesh)));
    }
    std::vector<std::string> lines;
    if (!joints.empty()) lines.push_back(translated("Turning joints: %1.", {listed(joints, kAllNames)}));
    if (!meshes.empty()) lines.push_back(translated("Gear meshes: %1.", {listed(meshes, kAllNames)}));
    return lines;
  }

  /// Joints of the mesh's cycle with their signs, ascending; none without a tree.
  [[nodiscard]] std::vector<std::pair<int, int>> cycleOf(MeshOrdinal mesh) const {
    std::vector<std::pair<int, int>> cycle;
    const IntegerMatrixPtr& matrix = m_snapshot.matrix(MatrixKind::spanningTree);
    if (!matrix) return cycle;
    std::vector<MatrixEntry> entries;
    matrix->rowEntries(mesh, entries);
    for (const MatrixEntry& entry : entries) cycle.emplace_back(entry.column, entry.value);
    return cycle;
  }

  [[nodiscard]] std::vector<std::string> meshLines(MeshOrdinal mesh) const {
    std::vector<std::string> lines{gearsText(mesh)};
    std::vector<std::string> along;
    std::vector<std::string> against;
    for (const auto& [joint, sign] : cycleOf(mesh))
      (sign > 0 ? along : against).push_back(std::to_string(m_mechanism.jointLabel(joint)));
    const std::string ahead = listed(along, kAllNames);
    const std::string back = listed(against, kAllNames);
    if (!along.empty() && !against.empty()) {
      lines.push_back(translated("Its cycle runs along %1 and against %2.", {ahead, back}));
    } else if (!along.empty()) {
      lines.push_back(translated("Its cycle runs along %1.", {ahead}));
    } else if (!against.empty()) {
      lines.push_back(translated("Its cycle runs against %1.", {back}));
    }
    return lines;
  }

  /// "Gears of link 1 and link 2 on link 3, external, 20 : 30 teeth."
  [[nodiscard]] std::string gearsText(MeshOrdinal mesh) const {
    const GearMesh& gears = m_mechanism.gearMeshes[mesh];
    const DigraphEdge& edge = m_graph.meshEdge(mesh);
    const std::string tail = linkName(edge.tail), head = linkName(edge.head);
    const std::string tailTeeth = std::to_string(gears.tailTeeth),
                      headTeeth = std::to_string(gears.headTeeth);
    const std::string kind = gears.kind ? kindWord(*gears.kind) : std::string();
    std::optional<int> carrier;
    if (m_snapshot.kinematics) {
      const auto& vertices = m_snapshot.kinematics->ttGraph->transferVertices().ofMesh;
      if (const auto& vertex = vertices[mesh]) carrier = vertex->carrier;
    }
    if (carrier && gears.kind)
      return translated("Gears of %1 and %2 on %3, %4, %5 : %6 teeth.",
                        {tail, head, linkName(*carrier), kind, tailTeeth, headTeeth});
    if (carrier)
      return translated("Gears of %1 and %2 on %3, %4 : %5 teeth.",
                        {tail, head, linkName(*carrier), tailTeeth, headTeeth});
    if (gears.kind)
      return translated("Gears of %1 and %2, %3, %4 : %5 teeth.", {tail, head, kind, tailTeeth, headTeeth});
    return translated("Gears of %1 and %2, %3 : %4 teeth.", {tail, head, tailTeeth, headTeeth});
  }

  void writeJoints() {
    const std::vector<AngleLimits> limits = angleLimits(m_mechanism);
    m_json.key("joints");
    m_json.beginArray();
    for (JointOrdinal joint = 0; joint < m_mechanism.t(); ++joint) {
      const ElementId id = m_graph.edgeId(joint);
      m_json.beginObject(Layout::row);
      m_json.member("id", id.id.text());
      m_json.member("label", m_mechanism.jointLabel(joint));
      m_json.member("name", jointName(joint));
      const AngleLimits& limit = limits[static_cast<std::size_t>(joint)];
      if (std::isfinite(limit.low)) m_json.member("low", limit.low);
      if (std::isfinite(limit.high)) m_json.member("high", limit.high);
      m_json.endObject();
    }
    m_json.endArray();
  }

  void writeRows() {
    m_json.key("rows");
    m_json.beginArray();
    if (isSolved()) {
      const KinematicModel& model = *m_snapshot.kinematics->model;
      const CoefficientMatrix matrix(m_mechanism, model, m_snapshot.kinematics->placement());
      for (MeshOrdinal mesh = 0; mesh < matrix.rows(); ++mesh) {
        const Rational ratio = matrix.ratio(mesh);
        m_json.beginArray(Layout::row);
        for (const CoefficientMatrix::Entry& entry : matrix.row(mesh)) {
          const Rational size = entry.tail ? ratio : Rational(1);
          coefficient(entry.joint, entry.sign > 0 ? size : -size);
        }
        m_json.endArray();
      }
      writeHeld(model.held());
    }
    m_json.endArray();
    m_json.member("meshRows", isSolved() ? m_mechanism.c() : 0);
  }

  void writeHeld(const std::vector<KinematicModel::HeldRow>& rows) {
    for (const KinematicModel::HeldRow& held : rows) {
      m_json.beginArray(Layout::row);
      for (const KinematicModel::HeldRow::Term& term : held.joints)
        coefficient(term.of, Rational(term.factor));
      m_json.endArray();
    }
  }

  /// Each as it is when it is put in. Those that lock the train, or leave it too free, have no inputs.
  void writeStates(const std::stop_token& stop) {
    m_json.key("states");
    m_json.beginArray();
    for (int state = 0; isSolved() && state < static_cast<int>(m_mechanism.states.size()); ++state) {
      const Expected<Mechanism> engaged = withStateEngaged(m_mechanism, state);
      const SnapshotPtr snapshot =
          engaged ? analyzeLive(std::make_shared<const Mechanism>(*engaged), 0, stop) : nullptr;
      if (stop.stop_requested()) break;
      const MatroidAnalysis* matroid = snapshot ? snapshot->matroid() : nullptr;
      m_json.beginObject();
      m_json.member("name", m_mechanism.states[static_cast<std::size_t>(state)].name);
      m_json.key("rows");
      m_json.beginArray();
      if (matroid != nullptr) writeHeld(snapshot->kinematics->model->held());
      m_json.endArray();
      const bool runs = matroid != nullptr && matroid->solution.has_value();
      writeChoice(runs ? matroid : nullptr);
      m_json.endObject();
    }
    m_json.endArray();
    m_json.member("state", engagedState(m_mechanism));
  }

  /// By link: none for the ground, else what carries it, its joint, +1 where the joint's arrow leads to it,
  /// and the line of the joint in the reference pose.
  void writeMovers() {
    const std::vector<TurningLine> lines = turningLines(m_snapshot.kinematics->placement());
    const SpanningTree& tree = *m_snapshot.tree;
    m_json.key("movers");
    m_json.beginArray();
    m_json.null();
    for (LinkOrdinal link = 1; link <= m_graph.n(); ++link) {
      const JointOrdinal joint = tree.jointToParent(link);
      const TurningLine& line = lines[static_cast<std::size_t>(joint)];
      m_json.beginObject(Layout::row);
      m_json.member("parent", tree.parent(link));
      m_json.member("joint", joint);
      m_json.member("sense", -tree.directionToGround(joint));
      m_json.key("point");
      m_json.beginArray(Layout::row);
      for (const double each : line.point) m_json.number(each);
      m_json.endArray();
      m_json.key("direction");
      m_json.beginArray(Layout::row);
      for (const double each : line.direction) m_json.number(each);
      m_json.endArray();
      m_json.endObject();
    }
    m_json.endArray();
  }

  void coefficient(JointOrdinal joint, const Rational& value) {
    m_json.beginArray(Layout::row);
    m_json.number(static_cast<std::int64_t>(joint));
    m_json.string(value.toString());
    m_json.endArray();
  }

  void writeInputs() { writeChoice(isSolved() ? m_snapshot.matroid() : nullptr); }

  void writeChoice(const MatroidAnalysis* matroid) {
    m_json.key("inputs");
    m_json.beginArray(Layout::row);
    if (matroid != nullptr)
      for (const JointOrdinal joint : matroid->choice.joints) m_json.number(static_cast<std::int64_t>(joint));
    m_json.endArray();
    m_json.key("speeds");
    m_json.beginArray(Layout::row);
    if (matroid != nullptr)
      for (const Rational& speed : matroid->speeds) m_json.string(speed.toString());
    m_json.endArray();
  }

  [[nodiscard]] bool isSolved() const {
    return m_snapshot.matroid() != nullptr && m_snapshot.matroid()->solution.has_value();
  }

  JsonWriter m_json;
  const AnalysisSnapshot& m_snapshot;
  const Mechanism& m_mechanism;
  const Digraph& m_graph;
};

}  // namespace

std::string handoutData(const AnalysisSnapshot& snapshot, const MechanismScene* stage, double tolerance,
                        const HandoutLevers& levers, const std::stop_token& stop) {
  TextSink sink;
  DataWriter(sink, snapshot).write(stage, tolerance, levers, stop);
  std::string text;
  for (const char letter : sink.text()) {
    if (letter == '<') {
      text += "\\u003c";
    } else {
      text += letter;
    }
  }
  return text;
}

}  // namespace geargraph
