#include "core/presentation/manual/manual_picture.h"

#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/layout.h"
#include "core/presentation/drawing/tt_graph_drawing.h"
#include "core/presentation/drawing/tt_graph_layout.h"
#include "core/presentation/schematic/schematic.h"
#include "core/teaching/lessons/course.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {
namespace {

/// What comes before the sign; the rest stays in `text`.
std::string_view taken(std::string_view& text, char sign) {
  const std::size_t end = text.find(sign);
  const std::string_view first = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return first;
}

constexpr Emphasis kSelected{.hovered = false, .selected = true, .walk = 0, .second = false};

/// False where the mechanism has no such mesh or no spanning tree.
bool markCycle(const AnalysisSnapshot& snapshot, const std::string& mesh, Emphases& emphases) {
  const IntegerMatrixPtr& cycles = snapshot.matrix(MatrixKind::cycleBasis);
  if (!cycles) return false;
  for (int row = 0; row < cycles->rows(); ++row) {
    if (cycles->rowHeading(row).element != ElementId(MeshId(mesh))) continue;
    std::vector<MatrixEntry> entries;
    cycles->rowEntries(row, entries);
    for (const MatrixEntry& entry : entries)
      emphases[cycles->columnHeading(entry.column).element].walk = entry.value;
    return true;
  }
  return false;
}

bool markAll(const Mechanism& mechanism, std::string_view kind, Emphases& emphases) {
  if (kind == "links") {
    for (std::size_t i = 1; i < mechanism.links.size(); ++i) emphases[mechanism.links[i].id] = kSelected;
  } else if (kind == "joints") {
    for (const TurningJoint& joint : mechanism.turningJoints) emphases[joint.id] = kSelected;
  } else if (kind == "meshes") {
    for (const GearMesh& mesh : mechanism.gearMeshes) emphases[mesh.id] = kSelected;
  } else {
    return false;
  }
  return true;
}

bool mark(const AnalysisSnapshot& snapshot, std::string_view name, Emphases& emphases) {
  const Mechanism& mechanism = *snapshot.mechanism;
  if (name.find('.') == std::string_view::npos) return markAll(mechanism, name, emphases);
  const std::string_view kind = taken(name, '.');
  const std::string id(name);
  if (kind == "cycle") return markCycle(snapshot, id, emphases);
  if (kind == "link" && mechanism.find(LinkId(id)) != nullptr) {
    emphases[LinkId(id)] = kSelected;
  } else if (kind == "joint" && mechanism.find(JointId(id)) != nullptr) {
    emphases[JointId(id)] = kSelected;
  } else if (kind == "mesh" && mechanism.find(MeshId(id)) != nullptr) {
    emphases[MeshId(id)] = kSelected;
  } else {
    return false;
  }
  return true;
}

std::optional<DisplayList> drawn(const AnalysisSnapshot& snapshot, std::string_view view,
                                 const Emphases& emphases) {
  const Mechanism& mechanism = *snapshot.mechanism;
  if (view == "digraph") return digraphDrawing(mechanism, completedPositions(mechanism), emphases);
  if (view == "schematic") return schematicDrawing(schematicGeometry(*snapshot.geometry), emphases);
  if (view != "ttgraph") return std::nullopt;
  const TtGraph* graph = snapshot.kinematics ? snapshot.kinematics->ttGraph.get() : nullptr;
  const NodePositions places = ttPositions(ttLayout(mechanism, graph), mechanism.view.ttNodes);
  return ttGraphDrawing(ttGraphGeometry(mechanism, graph, places), emphases);
}

}  // namespace

std::optional<DisplayList> manualPicture(std::string_view name) {
  const std::string_view view = taken(name, '/');
  const Expected<MechanismPtr> example = bundledExample(std::string(taken(name, '/')));
  if (!example) return std::nullopt;
  const SnapshotPtr snapshot = analyzeLive(*example);
  Emphases emphases;
  while (!name.empty())
    if (!mark(*snapshot, taken(name, '+'), emphases)) return std::nullopt;
  return drawn(*snapshot, view, emphases);
}

}  // namespace geargraph
