#include <algorithm>
#include <cmath>

#include "core/design/fixes/fix_makers.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/fresh_ids.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {
namespace {

constexpr double kWhole = 1e-6;  // teeth: how far from a whole number decimals in a file may lead

std::string teethText(const Mechanism& mechanism, const GearMesh& mesh, int tail, int head) {
  const bool ofTail = tail != mesh.tailTeeth;
  return translated("Use %1 teeth on gear %2",
                    {std::to_string(ofTail ? tail : head),
                     labelOf(mechanism, ofTail ? mesh.tail : mesh.head).value_or("")});
}

/// What a wheel would have to have where the pitch point is: N_head = N_tail r_head / r_tail, and the other
/// way round, where it is whole.
void addFittingTeeth(const AnalysisSnapshot& snapshot, const GearMesh& mesh, std::vector<Fix>& fixes) {
  if (!snapshot.tree || !snapshot.kinematics || !mesh.pitchPoint) return;
  const Digraph& graph = *snapshot.graph;
  const Placement& placement = snapshot.kinematics->placement();
  const auto path = treePath(*snapshot.tree, graph.nodeOf(mesh.tail), graph.nodeOf(mesh.head));
  if (path.size() < 2 || !placement.classes) return;
  const Vector3 point{(*mesh.pitchPoint)[0].value(), (*mesh.pitchPoint)[1].value(),
                      (*mesh.pitchPoint)[2].value()};
  const auto radius = [&](JointOrdinal joint) {
    const AxisLine& line = placement.lineOfClass(placement.classes->classOf[joint]);
    return length(cross(line.direction, point - line.point));
  };
  const double tailRadius = radius(path.front().joint), headRadius = radius(path.back().joint);
  if (tailRadius == 0 || headRadius == 0) return;  // the point lies on an axis: no teeth would fit
  const double ratio = headRadius / tailRadius;
  const auto offer = [&](int tail, int head) {
    if (std::min(tail, head) < kMinTeeth || std::max(tail, head) > kMaxTeeth) return;
    fixes.push_back(
        {teethText(*snapshot.mechanism, mesh, tail, head),
         [id = mesh.id, tail, head](const Mechanism& before) { return withTeeth(before, id, tail, head); }});
  };
  const double head = mesh.tailTeeth * ratio;
  const double tail = mesh.headTeeth / ratio;
  if (std::abs(head - std::round(head)) < kWhole * head && head < kMaxTeeth) {
    offer(mesh.tailTeeth, static_cast<int>(std::lround(head)));
  }
  if (std::abs(tail - std::round(tail)) < kWhole * tail && tail < kMaxTeeth) {
    offer(static_cast<int>(std::lround(tail)), mesh.headTeeth);
  }
}

Fix kindFix(const Mechanism& mechanism, const GearMesh& mesh, MeshKind kind) {
  return {filled(translated(std::string_view(pairKind(kind).makeIt)), {wordFor(mechanism, mesh.id)}),
          [id = mesh.id, kind](const Mechanism& before) { return withMeshKind(before, id, kind); }};
}

void addKinds(const Mechanism& mechanism, const GearMesh& mesh, std::vector<Fix>& fixes) {
  for (const MeshKind kind : meshKinds()) {
    // A gear that does not fit is not meant as a belt.
    if (mesh.kind == kind || !mesh.kind || touches(kind) != touches(*mesh.kind)) continue;
    if (slides(kind) != slides(*mesh.kind)) continue;
    fixes.push_back(kindFix(mechanism, mesh, kind));
  }
}

std::vector<Fix> geometryFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  const Mechanism& mechanism = *snapshot.mechanism;
  const GearMesh* mesh =
      diagnostic.elements.empty() ? nullptr : mechanism.find(MeshId(diagnostic.elements.front().id));
  if (mesh == nullptr) return {};
  if (diagnostic.detail == Detail::skewAxes) {
    std::vector<Fix> crossing;
    for (const MeshKind kind : meshKinds()) {
      if (hasSkewAxes(kind) && !slides(kind)) crossing.push_back(kindFix(mechanism, *mesh, kind));
    }
    crossing.push_back(removalOf(snapshot, mesh->id));
    return crossing;
  }
  if (diagnostic.detail == Detail::coincidentAxes)
    return {removalOf(snapshot, mesh->id)};  // the axes themselves would have to move
  std::vector<Fix> fixes;
  addFittingTeeth(snapshot, *mesh, fixes);
  addKinds(mechanism, *mesh, fixes);
  if (mesh->pitchPoint) {
    fixes.push_back(
        {translated("Let the pitch point follow from axes and teeth"),
         [id = mesh->id](const Mechanism& before) { return withPitchPoint(before, id, std::nullopt); }});
  }
  if (mesh->pitchPoint && mesh->kind) {
    fixes.push_back({translated("Let pitch point and kind follow from the axes"),
                     [id = mesh->id](const Mechanism& before) {
                       Expected<Mechanism> next = withPitchPoint(before, id, std::nullopt);
                       return next ? withMeshKind(std::move(next).value(), id, std::nullopt) : next;
                     }});
  }
  fixes = tried(std::move(fixes), mechanism, [&](const Mechanism& repaired) {
    const Diagnostics left = placementOf(repaired).diagnostics;
    return std::any_of(left.begin(), left.end(), [&](const Diagnostic& each) {
      return each.severity() == Severity::error && each.elements == diagnostic.elements;
    });
  });
  fixes.push_back(removalOf(snapshot, mesh->id));
  return fixes;
}

/// The joints of each class beyond the first get an axis of their own, in the same place.
Expected<Mechanism> withAxisSplit(Mechanism mechanism, AxisId axis,
                                  const std::vector<std::vector<JointId>>& groups) {
  const Axis shared = *mechanism.find(axis);
  for (const std::vector<JointId>& group : groups) {
    Axis own = shared;
    own.id = freshAxisIds(mechanism, 1).front();
    mechanism.axes.push_back(own);
    for (const JointId joint : group) {
      Expected<Mechanism> moved = withJointAxis(std::move(mechanism), joint, own.id);
      if (!moved) return moved.error();
      mechanism = std::move(moved).value();
    }
  }
  return mechanism;
}

std::vector<Fix> axisFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  const Mechanism& mechanism = *snapshot.mechanism;
  if (diagnostic.elements.empty() || !snapshot.kinematics || !snapshot.kinematics->placement().classes)
    return {};
  const AxisId axis(diagnostic.elements.front().id);
  const AxisGroups& classes = *snapshot.kinematics->placement().classes;
  std::vector<int> known;
  std::vector<std::vector<JointId>> groups;
  for (std::size_t joint = 0; joint < mechanism.turningJoints.size(); ++joint) {
    if (mechanism.turningJoints[joint].axis != axis) continue;
    const auto found = std::find(known.begin(), known.end(), classes.classOf[joint]);
    const auto group = static_cast<std::size_t>(found - known.begin());
    if (found == known.end()) {
      known.push_back(classes.classOf[joint]);
      groups.emplace_back();
    }
    groups[group].push_back(mechanism.turningJoints[joint].id);
  }
  if (groups.size() < 2) return {};
  groups.erase(groups.begin());
  return {{translated("Give each its own axis"),
           [axis, groups](const Mechanism& before) { return withAxisSplit(before, axis, groups); }}};
}

}  // namespace

std::vector<Fix> meshFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot) {
  switch (diagnostic.code) {
    case Code::splitAxis:
      return axisFixes(diagnostic, snapshot);
    case Code::coaxialMesh:
    case Code::noTransferVertex:
    case Code::redundantMesh:
      if (diagnostic.detail == Detail::equalPlanets) return {};  // it is drawn on purpose
      for (const ElementId& element : diagnostic.elements) {
        if (element.kind == ElementKind::gearMesh) return {removalOf(snapshot, element)};
      }
      return {};
    default:
      return geometryFixes(diagnostic, snapshot);
  }
}

}  // namespace geargraph
