#include "core/teaching/lessons/quantities.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/graph/spanning_tree.h"
#include "core/theory/levers/lever_plan.h"
#include "core/theory/statics/statics_report.h"

namespace geargraph {
namespace {

constexpr int kNoCoupling = -2;  ///< the position of no coupling, and not that of a balance

struct LessonQuantityEntry {
  LessonQuantity quantity;
  std::string_view name;
  bool needsName = false;
  bool isSet = false;
};

constexpr std::array kQuantities = {
    LessonQuantityEntry{LessonQuantity::links, "links"},
    LessonQuantityEntry{LessonQuantity::turningJoints, "turning-joints"},
    LessonQuantityEntry{LessonQuantity::gearMeshes, "gear-meshes"},
    LessonQuantityEntry{LessonQuantity::externalMeshes, "external-meshes"},
    LessonQuantityEntry{LessonQuantity::internalMeshes, "internal-meshes"},
    LessonQuantityEntry{LessonQuantity::bevelMeshes, "bevel-meshes"},
    LessonQuantityEntry{LessonQuantity::couplings, "couplings"},
    LessonQuantityEntry{LessonQuantity::rank, "rank"},
    LessonQuantityEntry{LessonQuantity::dof, "dof"},
    LessonQuantityEntry{LessonQuantity::kutzbachDof, "kutzbach-dof"},
    LessonQuantityEntry{LessonQuantity::errors, "errors"},
    LessonQuantityEntry{LessonQuantity::finding, "finding", true},
    LessonQuantityEntry{LessonQuantity::blamed, "blamed", true, true},
    LessonQuantityEntry{LessonQuantity::rate, "rate", true},
    LessonQuantityEntry{LessonQuantity::outputRates, "output-rates"},
    LessonQuantityEntry{LessonQuantity::ratio, "ratio", true},
    LessonQuantityEntry{LessonQuantity::torque, "torque", true},
    LessonQuantityEntry{LessonQuantity::cycle, "cycle", true, true},
    LessonQuantityEntry{LessonQuantity::transferVertex, "transfer-vertex", true, true},
    LessonQuantityEntry{LessonQuantity::groundJoints, "ground-joints"},
    LessonQuantityEntry{LessonQuantity::axes, "axes"},
    LessonQuantityEntry{LessonQuantity::jointsOf, "joints-of", true},
    LessonQuantityEntry{LessonQuantity::meshesOf, "meshes-of", true},
    LessonQuantityEntry{LessonQuantity::gearSizes, "gear-sizes", true},
    LessonQuantityEntry{LessonQuantity::unequalCentres, "unequal-centres"},
    LessonQuantityEntry{LessonQuantity::leverPlace, "lever-place", true},
};

const LessonQuantityEntry& entryOf(LessonQuantity quantity) {
  const LessonQuantityEntry& entry = kQuantities[static_cast<std::size_t>(quantity)];
  GEARGRAPH_REQUIRE(entry.quantity == quantity);
  return entry;
}

Diagnostic notDefined(const std::string& why) {
  return {Code::schema, why, {}, {}};
}

Diagnostic unknown(const char* sentence, const std::string& name) {
  return {Code::unknownId, filled(translated(sentence), {name}), {}, {}};
}

QuantityValues number(Rational value) {
  return {{std::move(value)}, {}};
}

template <class List>
std::optional<int> positionOf(const List& list, const std::string& id) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const auto& element) { return element.id.text() == id; });
  if (found == list.end()) return std::nullopt;
  return static_cast<int>(found - list.begin());
}

bool isCalled(const Diagnostic& diagnostic, const std::string& name) {
  return codeName(diagnostic.code) == name ||
         (diagnostic.detail != Detail::none && detailName(diagnostic.detail) == name);
}

bool isLabelled(const ElementId& element) {
  return element.kind == ElementKind::link || element.kind == ElementKind::turningJoint ||
         element.kind == ElementKind::gearMesh;
}

std::int64_t jointsOn(const Mechanism& mechanism, const LinkId& link) {
  return std::count_if(mechanism.turningJoints.begin(), mechanism.turningJoints.end(),
                       [&](const TurningJoint& joint) { return joint.tail == link || joint.head == link; });
}

/// By their lines, as far as these are known, else by the axes of the document.
std::int64_t axesIn(const Mechanism& mechanism, const AnalysisSnapshot& live) {
  std::set<int> lines;
  std::set<std::string> axes;
  for (JointOrdinal joint = 0; joint < mechanism.t(); ++joint) {
    if (live.kinematics) lines.insert(live.kinematics->placement().classes->classOf[joint]);
    axes.insert(mechanism.turningJoints[joint].axis.text());
  }
  return live.kinematics ? std::ssize(lines) : std::ssize(axes);
}

/// The centre distance of two gears on parallel axes, in halves of their module; 0 for bevels.
int distanceInTeeth(const MeshGeometry& mesh) {
  return hasParallelAxes(mesh.kind) ? distanceTeeth(mesh.kind, mesh.tailTeeth, mesh.headTeeth) : 0;
}

/// A gear that is in two meshes has one module: between the same axes both need the same distance.
std::int64_t unequalCentresIn(const AnalysisSnapshot& live) {
  if (!live.kinematics) return 0;
  const auto& meshes = live.kinematics->placement().meshes;
  const auto shareGear = [](const MeshGeometry& a, const MeshGeometry& b) {
    const auto isIn = [&](LinkOrdinal link, int teeth) {
      return (b.tail == link && b.tailTeeth == teeth) || (b.head == link && b.headTeeth == teeth);
    };
    return isIn(a.tail, a.tailTeeth) || isIn(a.head, a.headTeeth);
  };
  const auto axesOf = [](const MeshGeometry& mesh) {
    const int tail = mesh.tailClass;
    const int head = mesh.headClass;
    return std::pair(std::min(tail, head), std::max(tail, head));
  };
  std::int64_t pairs = 0;
  for (auto a = meshes.begin(); a != meshes.end(); ++a) {
    for (auto b = meshes.begin(); b != a; ++b) {
      if (!*a || !*b || !shareGear(**a, **b)) continue;
      const bool isSame = axesOf(**a) == axesOf(**b);
      pairs += isSame && distanceInTeeth(**a) != distanceInTeeth(**b) ? 1 : 0;
    }
  }
  return pairs;
}

/// Joints, meshes or sizes of gears of a link.
Expected<QuantityValues> partsOf(const Mechanism& mechanism, const AskedQuantity& asked) {
  const LinkId link(asked.of);
  if (!positionOf(mechanism.links, asked.of))
    return unknown(toTranslate("The document has no link \"%1\"."), asked.of);
  if (asked.quantity == LessonQuantity::jointsOf) return number(jointsOn(mechanism, link));
  std::int64_t meshes = 0;
  std::set<int> sizes;
  for (const GearMesh& mesh : mechanism.gearMeshes) {
    meshes += mesh.tail == link || mesh.head == link ? 1 : 0;
    if (mesh.tail == link) sizes.insert(mesh.tailTeeth);
    if (mesh.head == link) sizes.insert(mesh.headTeeth);
  }
  return number(asked.quantity == LessonQuantity::meshesOf ? meshes
                                                           : static_cast<std::int64_t>(sizes.size()));
}

}  // namespace

std::string_view quantityName(LessonQuantity quantity) {
  return entryOf(quantity).name;
}

std::optional<LessonQuantity> quantityFromName(std::string_view name) {
  const auto found = std::find_if(kQuantities.begin(), kQuantities.end(),
                                  [&](const LessonQuantityEntry& entry) { return entry.name == name; });
  if (found == kQuantities.end()) return std::nullopt;
  return found->quantity;
}

bool needsName(LessonQuantity quantity) {
  return entryOf(quantity).needsName;
}

bool isSetOfElements(LessonQuantity quantity) {
  return entryOf(quantity).isSet;
}

LessonAnalysis::LessonAnalysis(MechanismPtr mechanism, std::stop_token stop)
    : m_mechanism(std::move(mechanism)), m_stop(std::move(stop)) {}

const AnalysisSnapshot& LessonAnalysis::live() {
  // Parts of a mechanism are asked for after this one: a stop is looked at where they are, and this one is
  // fast.
  if (!m_live) m_live = analyzeLive(m_mechanism);
  return *m_live;
}

const Diagnostics& LessonAnalysis::diagnostics() {
  static const Diagnostics kNone;
  live();
  if (!m_complete) m_complete = analyzeFully(m_live, {false}, m_stop);
  return m_complete ? m_complete->diagnostics : kNone;
}

Expected<QuantityValues> LessonAnalysis::valuesOf(const AskedQuantity& asked) {
  const auto meshes = [&](MeshKind kind) {
    const auto& all = m_mechanism->gearMeshes;
    const LiveKinematicsPtr& kinematics = live().kinematics;
    std::int64_t count = 0;
    for (std::size_t mesh = 0; mesh < all.size(); ++mesh) {
      const auto& placed = kinematics ? kinematics->placement().meshes[mesh] : std::nullopt;
      count += (placed ? placed->kind : all[mesh].kind) == kind ? 1 : 0;
    }
    return number(count);
  };
  switch (asked.quantity) {
    case LessonQuantity::links:
      return number(m_mechanism->n());
    case LessonQuantity::turningJoints:
      return number(m_mechanism->t());
    case LessonQuantity::gearMeshes:
      return number(m_mechanism->c());
    case LessonQuantity::externalMeshes:
      return meshes(MeshKind::external);
    case LessonQuantity::internalMeshes:
      return meshes(MeshKind::internal);
    case LessonQuantity::bevelMeshes:
      return meshes(MeshKind::bevel);
    case LessonQuantity::couplings:
      return number(static_cast<std::int64_t>(m_mechanism->couplings.size()));
    case LessonQuantity::rank:
    case LessonQuantity::dof:
    case LessonQuantity::kutzbachDof: {
      const MatroidAnalysis* const matroid = live().matroid();
      if (matroid == nullptr)
        return notDefined(translated("The degrees of freedom are not defined yet: the document has errors."));
      return number(asked.quantity == LessonQuantity::rank  ? matroid->rank
                    : asked.quantity == LessonQuantity::dof ? matroid->dof
                                                            : matroid->kutzbachDof);
    }
    case LessonQuantity::errors:
    case LessonQuantity::finding:
    case LessonQuantity::blamed:
      return diagnosticValues(asked);
    case LessonQuantity::rate:
    case LessonQuantity::outputRates:
      return ratesOf(asked);
    case LessonQuantity::ratio:
      return ratioOf(asked.of);
    case LessonQuantity::torque:
      return torqueOf(asked.of);
    case LessonQuantity::cycle:
    case LessonQuantity::transferVertex:
      return walkOf(asked);
    case LessonQuantity::groundJoints:
      return number(jointsOn(*m_mechanism, m_mechanism->links.front().id));
    case LessonQuantity::axes:
      return number(axesIn(*m_mechanism, live()));
    case LessonQuantity::unequalCentres:
      return number(unequalCentresIn(live()));
    case LessonQuantity::jointsOf:
    case LessonQuantity::meshesOf:
    case LessonQuantity::gearSizes:
      return partsOf(*m_mechanism, asked);
    case LessonQuantity::leverPlace:
      return leverPlaceOf(asked.of);
  }
  return notDefined(translated("This quantity is not known."));
}

QuantityValues LessonAnalysis::diagnosticValues(const AskedQuantity& asked) {
  std::int64_t count = 0;
  QuantityValues values;
  for (const Diagnostic& diagnostic : diagnostics()) {
    const bool counts = asked.quantity == LessonQuantity::errors ? diagnostic.severity() == Severity::error
                                                                 : isCalled(diagnostic, asked.of);
    if (!counts) continue;
    ++count;
    if (asked.quantity != LessonQuantity::blamed) continue;
    for (const ElementId& element : diagnostic.elements) {
      const bool isNew =
          std::find(values.elements.begin(), values.elements.end(), element) == values.elements.end();
      if (isNew && isLabelled(element)) values.elements.push_back(element);
    }
  }
  if (asked.quantity != LessonQuantity::blamed) values.numbers = {count};
  return values;
}

Expected<QuantityValues> LessonAnalysis::ratesOf(const AskedQuantity& asked) {
  const MatroidAnalysis* const matroid = live().matroid();
  const std::optional<int> joint = positionOf(m_mechanism->turningJoints, asked.of);
  if (asked.quantity == LessonQuantity::rate && !joint)
    return unknown(toTranslate("The document has no turning joint \"%1\"."), asked.of);
  if (matroid == nullptr || !matroid->solution)
    return notDefined(translated("The speeds are not determined yet: see Problems."));
  const auto exact = solveExact(*live().kinematics->model, matroid->choice.joints, matroid->speeds, m_stop);
  if (!exact) return notDefined(translated("The solution was cancelled."));
  if (joint) return number(exact->rates[*joint]);
  QuantityValues values;
  for (const int output : exact->outputs) {
    const DigraphEdge& edge = live().graph->turningEdge(output);
    if (edge.tail == 0 || edge.head == 0) values.numbers.push_back(exact->rates[output]);
  }
  return values;
}

Expected<QuantityValues> LessonAnalysis::ratioOf(const std::string& state) {
  const auto& states = m_mechanism->states;
  const auto found =
      std::find_if(states.begin(), states.end(), [&](const ShiftState& s) { return s.name == state; });
  if (found == states.end()) return unknown(toTranslate("The document has no state \"%1\"."), state);
  const LiveKinematicsPtr& kinematics = live().kinematics;
  if (!kinematics || !kinematics->model)
    return notDefined(translated("The document has errors: no state has a ratio."));
  const auto solved = solveState(*m_mechanism, *kinematics->model, kinematics->placement(),
                                 static_cast<int>(found - states.begin()), false, m_stop);
  if (!solved || !solved->ratio) return notDefined(translated("State \"%1\" has no ratio.", {state}));
  return number(*solved->ratio);
}

Expected<QuantityValues> LessonAnalysis::torqueOf(const std::string& holder) {
  const LiveKinematicsPtr& kinematics = live().kinematics;
  const MatroidAnalysis* const matroid = live().matroid();
  if (matroid == nullptr || !kinematics->ttGraph->isComplete())
    return notDefined(translated("The document has errors: torques are not determined."));
  StaticsOptions options;
  options.symbolic = false;
  const auto report = analyzeStatics(*m_mechanism, *kinematics->model, kinematics->placement(),
                                     *kinematics->ttGraph, *matroid, options, m_stop);
  if (!report || !report->isSolved || !report->solution().isBalanced())
    return notDefined(translated("The loads are not held: torques are not determined."));
  const int meshes = m_mechanism->c();
  const std::optional<int> joint = positionOf(m_mechanism->turningJoints, holder);
  const ShiftElementOrdinal coupling = positionOf(m_mechanism->couplings, holder).value_or(kNoCoupling);
  for (std::size_t i = 0; i < report->held.size(); ++i) {
    const HeldPart& part = report->held[i];
    const bool isJoint = part.balance >= 0 && joint &&
                         report->problem.balances[static_cast<std::size_t>(part.balance)].joint == *joint;
    const bool isCoupling = part.coupling >= 0 && part.isMain && part.coupling == coupling;
    if (!isJoint && !isCoupling) continue;
    const int unknownNumber = meshes + static_cast<int>(i);
    const Real& torque = report->solution().values[static_cast<std::size_t>(unknownNumber)];
    if (!report->solution().isDetermined(unknownNumber) || !torque.isExact())
      return notDefined(translated("The torque of \"%1\" is not determined as a fraction.", {holder}));
    return number(*torque.fraction());
  }
  return unknown(toTranslate("The document has no balance or engaged coupling \"%1\"."), holder);
}

Expected<QuantityValues> LessonAnalysis::leverPlaceOf(const std::string& link) {
  const std::optional<int> ordinal = positionOf(m_mechanism->links, link);
  if (!ordinal) return unknown(toTranslate("The document has no link \"%1\"."), link);
  const LiveKinematicsPtr& kinematics = live().kinematics;
  if (kinematics && kinematics->model) {
    const auto plan = leverPlanOf(*kinematics->model, kinematics->placement(), {}, m_stop);
    for (const Lever& lever : plan ? plan->levers : std::vector<Lever>()) {
      if (const LeverPoint* const point = lever.pointOf(*ordinal)) return number(point->at);
    }
  }
  return notDefined(translated("Link \"%1\" is on no lever.", {link}));
}

Expected<QuantityValues> LessonAnalysis::walkOf(const AskedQuantity& asked) {
  const std::optional<int> mesh = positionOf(m_mechanism->gearMeshes, asked.of);
  if (!mesh) return unknown(toTranslate("The document has no gear mesh \"%1\"."), asked.of);
  const AnalysisSnapshot& snapshot = live();
  if (!snapshot.tree)
    return notDefined(translated("The turning joints are no spanning tree: meshes close no cycles."));
  const DigraphEdge& gears = snapshot.graph->meshEdge(*mesh);
  QuantityValues values;
  if (asked.quantity == LessonQuantity::transferVertex) {
    const auto& vertices = snapshot.kinematics->ttGraph->transferVertices().ofMesh;
    const auto& vertex = vertices[*mesh];
    if (!vertex) return notDefined(translated("Mesh \"%1\" has no transfer vertex.", {asked.of}));
    values.elements = {snapshot.graph->nodeId(vertex->carrier)};
    return values;
  }
  std::vector<int> joints;
  for (const PathStep& step : treePath(*snapshot.tree, gears.head, gears.tail)) joints.push_back(step.joint);
  std::sort(joints.begin(), joints.end());
  for (const JointOrdinal joint : joints) values.elements.push_back(snapshot.graph->edgeId(joint));
  return values;
}

}  // namespace geargraph
