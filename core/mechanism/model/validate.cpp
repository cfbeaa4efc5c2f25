#include "core/mechanism/model/validate.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/disjoint_sets.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/element_pointer.h"
#include "core/mechanism/model/limits.h"
#include "core/mechanism/model/load_checks.h"
#include "core/mechanism/model/mass_edits.h"
#include "core/mechanism/model/shapes.h"

namespace geargraph {
namespace {

Diagnostic makeDiagnostic(Code code, std::string message, std::vector<ElementId> elements,
                          std::string pointer = {}) {
  return {code, std::move(message), std::move(elements), std::move(pointer), 0, 0};
}

/// Collects what wellFormedDiagnostics() finds, list by list.
class WellFormedCheck {
 public:
  explicit WellFormedCheck(const Mechanism& mechanism) : m_mechanism(mechanism) {}

  Diagnostics run() {
    if (m_mechanism.links.empty()) {
      add(Code::schema, translated("A mechanism needs at least the ground."), {}, "/links");
    }
    for (Diagnostic& beyond : limitDiagnostics(m_mechanism)) m_diagnostics.push_back(std::move(beyond));
    uniqueIds(m_mechanism.links, ElementKind::link, m_links);
    uniqueIds(m_mechanism.axes, ElementKind::axis, m_axes);
    uniqueIds(m_mechanism.turningJoints, ElementKind::turningJoint, m_joints);
    uniqueIds(m_mechanism.gearMeshes, ElementKind::gearMesh, m_meshes);
    uniqueIds(m_mechanism.wheels, ElementKind::wheel, m_wheels);
    uniqueIds(m_mechanism.couplings, ElementKind::coupling, m_couplings);
    uniqueIds(m_mechanism.view.notes, ElementKind::note, m_notes);
    for (const Wheel& wheel : m_mechanism.wheels) m_linkOfWheel.emplace(wheel.id, wheel.link);
    checkShapes();
    checkAxes();
    checkJoints();
    checkMeshes();
    checkWheels();
    checkInputs();
    checkCouplings();
    checkStates();
    checkEngaged();
    for (Diagnostic& wrong : loadDiagnostics(m_mechanism)) m_diagnostics.push_back(std::move(wrong));
    for (Diagnostic& wrong : massDiagnostics(m_mechanism)) m_diagnostics.push_back(std::move(wrong));
    checkCamera();
    return std::move(m_diagnostics);
  }

 private:
  using Known = std::unordered_set<InternedString>;

  void add(Code code, std::string message, std::vector<ElementId> elements, std::string pointer) {
    m_diagnostics.push_back(
        makeDiagnostic(code, std::move(message), std::move(elements), std::move(pointer)));
  }

  template <class Element>
  void uniqueIds(const std::vector<Element>& list, ElementKind kind, Known& known) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      const InternedString id = list[i].id.atom();
      if (id.empty()) {
        add(Code::schema, translated("An id may not be empty."), {}, pointerTo(kind, i) + "/id");
      } else if (!known.insert(id).second) {
        add(Code::duplicateId, translated("The id \"%1\" occurs twice in %2.", {id.text(), listName(kind)}),
            {{kind, id}}, pointerTo(kind, i) + "/id");
      }
    }
  }

  /// A reference from `owner` to an element of another list.
  void reference(const ElementId& owner, const ElementId& to, const Known& known,
                 const std::string& pointer) {
    if (known.contains(to.id)) return;
    add(Code::unknownId,
        translated("%1 \"%2\" names \"%3\", but %4 has no such id.",
                   {listName(owner.kind), owner.id.text(), to.id.text(), listName(to.kind)}),
        {owner, to}, pointer);
  }

  void notItself(const ElementId& owner, LinkId tail, LinkId head, const char* sentence,
                 const std::string& at) {
    if (tail != head) return;
    add(Code::selfJoint, filled(translated(sentence), {owner.id.text(), tail.text()}), {owner, tail},
        at + "/head");
  }

  void checkShapes() {
    for (std::size_t i = 0; i < m_mechanism.links.size(); ++i) {
      const Link& link = m_mechanism.links[i];
      for (std::size_t k = 0; k < link.shapes.size(); ++k) {
        const LinkShape& shape = link.shapes[k];
        const std::string at = pointerTo(ElementKind::link, i) + "/shapes/" + std::to_string(k);
        if (!staysInFolder(shape.file)) {
          add(Code::schema,
              translated(
                  "The 3D file of a link is a path that stays in the folder of the document, not \"%1\".",
                  {shape.file}),
              {link.id}, at + "/file");
        }
        if (shape.scale && shape.scale->exact().sign() <= 0)
          add(Code::schema, translated("The scale of a 3D file has to be above 0."), {link.id},
              at + "/scale");
      }
    }
  }

  void checkAxes() {
    for (std::size_t i = 0; i < m_mechanism.axes.size(); ++i) {
      const Axis& axis = m_mechanism.axes[i];
      if (axis.direction && isZero(*axis.direction)) {
        add(Code::schema, translated("The direction of axis %1 has length 0.", {'"' + axis.id.text() + '"'}),
            {axis.id}, pointerTo(ElementKind::axis, i) + "/direction");
      }
    }
  }

  void checkJoints() {
    for (std::size_t i = 0; i < m_mechanism.turningJoints.size(); ++i) {
      const TurningJoint& joint = m_mechanism.turningJoints[i];
      const std::string at = pointerTo(ElementKind::turningJoint, i);
      reference(joint.id, joint.tail, m_links, at + "/tail");
      reference(joint.id, joint.head, m_links, at + "/head");
      reference(joint.id, joint.axis, m_axes, at + "/axis");
      notItself(joint.id, joint.tail, joint.head,
                toTranslate("Turning joint \"%1\" ties link \"%2\" to itself; it needs two links."), at);
      if (const auto problem = limitsProblem(joint.limits))
        add(Code::schema, *problem, {joint.id}, at + "/limits");
    }
  }

  void checkMeshes() {
    for (std::size_t i = 0; i < m_mechanism.gearMeshes.size(); ++i) {
      const GearMesh& mesh = m_mechanism.gearMeshes[i];
      const std::string at = pointerTo(ElementKind::gearMesh, i);
      reference(mesh.id, mesh.tail, m_links, at + "/tail");
      reference(mesh.id, mesh.head, m_links, at + "/head");
      notItself(mesh.id, mesh.tail, mesh.head,
                toTranslate("Gear mesh \"%1\" ties link \"%2\" to itself; it needs two links."), at);
      teeth(mesh, mesh.tailTeeth, at + "/tailTeeth");
      teeth(mesh, mesh.headTeeth, at + "/headTeeth");
      wheelOf(mesh, mesh.tailWheel, mesh.tail, at + "/tailWheel");
      wheelOf(mesh, mesh.headWheel, mesh.head, at + "/headWheel");
      checkStrand(mesh, at);
      checkCrossing(mesh, at);
      if (mesh.faceWidth && mesh.faceWidth->value() <= 0) {  // 1e-999 is 0 for all who reckon with it
        add(Code::schema, translated("The face width of a gear mesh is above 0."), {mesh.id},
            at + "/faceWidth");
      }
      checkTeeth(mesh, at);
    }
  }

  void checkTeeth(const GearMesh& mesh, const std::string& at) {
    const auto outside = [](const std::optional<Number>& degrees) {
      return degrees && (degrees->exact().sign() < 0 || degrees->exact() >= Rational(90));
    };
    if (outside(mesh.helixAngle)) {
      add(Code::schema, translated("The helix angle of a gear mesh is at least 0 and below 90 degrees."),
          {mesh.id}, at + "/helixAngle");
    }
    if (mesh.module && mesh.module->value() <= 0)
      add(Code::schema, translated("The module of a gear mesh is above 0."), {mesh.id}, at + "/module");
    if (outside(mesh.pressureAngle) || (mesh.pressureAngle && mesh.pressureAngle->value() <= 0)) {
      add(Code::schema, translated("The pressure angle of a gear mesh is above 0 and below 90 degrees."),
          {mesh.id}, at + "/pressureAngle");
    }
  }

  void teeth(const GearMesh& mesh, int count, const std::string& pointer) {
    if (count >= kMinTeeth && count <= kMaxTeeth) return;
    add(Code::schema,
        translated("A gear has 1 to 100,000 teeth; mesh \"%1\" says %2.",
                   {mesh.id.text(), std::to_string(count)}),
        {mesh.id}, pointer);
  }

  /// Helices of pairs on skew axes, and of kinds that leave no choice.
  void checkCrossing(const GearMesh& mesh, const std::string& at) {
    const auto reject = [&](bool isThere, const char* member) {
      if (!isThere) return;
      add(Code::schema,
          translated(
              "The teeth of a face gear are straight, and those of a hypoid pair follow from its pitch "
              "point; mesh \"%1\" says otherwise: leave it out.",
              {mesh.id.text()}),
          {mesh.id}, at + member);
    };
    if (!pairKind(saidKind(mesh)).statesHelix) {
      reject(mesh.helixAngle.has_value(), "/helixAngle");
      reject(mesh.hand.has_value(), "/hand");
      reject(mesh.herringbone, "/herringbone");
      return;
    }
    if (!hasSkewAxes(saidKind(mesh)) || slides(saidKind(mesh))) return;
    if (mesh.herringbone) {
      add(Code::schema,
          translated(
              "Teeth that cross at an angle are no herringbone teeth; mesh \"%1\" says so: leave it out.",
              {mesh.id.text()}),
          {mesh.id}, at + "/herringbone");
    }
    if (pairKind(saidKind(mesh)).isThreaded && mesh.helixAngle) {
      add(Code::schema,
          translated("The helix of worm \"%1\" follows from its starts, the module and the distance of the "
                     "axes: leave "
                     "the helix angle out.",
                     {mesh.id.text()}),
          {mesh.id}, at + "/helixAngle");
    }
  }

  /// What ties the travel of a rack or a screw to a turn.
  void checkTravel(const GearMesh& mesh, const std::string& at) {
    const auto reject = [&](const char* sentence, const char* member) {
      add(Code::schema, filled(translated(sentence), {mesh.id.text()}), {mesh.id}, at + member);
    };
    if (!pairKind(saidKind(mesh)).hasTeeth) {
      if (!mesh.lead)
        return reject(toTranslate("Screw \"%1\" needs a lead: its advance in one turn."), "/lead");
      if (mesh.lead->value() <= 0)
        return reject(toTranslate("The lead of screw \"%1\" is above 0."), "/lead");
      if (mesh.module || mesh.helixAngle)
        reject(
            toTranslate("Screw \"%1\" has a lead and a hand, no module and no helix angle: leave them out."),
            mesh.module ? "/module" : "/helixAngle");
    } else if (mesh.module.has_value() == mesh.pitch.has_value()) {
      return reject(toTranslate("Rack \"%1\" has a module or a pitch along its motion, one of them."),
                    "/module");
    }
    for (const bool ofTail : {true, false}) {
      if (weightsOf(mesh, ofTail)) continue;
      return reject(
          toTranslate("The travel of a radian of \"%1\" is a ratio of two whole numbers up to 100,000: "
                      "give it with fewer digits."),
          mesh.lead    ? "/lead"
          : mesh.pitch ? "/pitch"
                       : "/module");
    }
  }

  /// The members that only some kinds have.
  void checkStrand(const GearMesh& mesh, const std::string& at) {
    const PairKind& kind = pairKind(saidKind(mesh));
    const bool isRack = kind.slides && kind.hasTeeth;
    const bool isScrew = kind.slides && !kind.hasTeeth;
    const auto reject = [&](const char* sentence, const char* member) {
      add(Code::schema, filled(translated(sentence), {mesh.id.text()}), {mesh.id}, at + member);
    };
    if (!kind.canCross) {
      const auto only = [&](bool isThere, const char* member) {
        if (isThere)
          reject(toTranslate("Only a belt is crossed, or has a pitch or running diameters; mesh \"%1\" is "
                             "none."),
                 member);
      };
      only(mesh.crossed, "/crossed");
      only(mesh.pitch.has_value() && !isRack, "/pitch");
      only(mesh.tailDiameter.has_value(), "/tailDiameter");
      only(mesh.headDiameter.has_value(), "/headDiameter");
      if (mesh.crossed || (mesh.pitch && !isRack) || mesh.tailDiameter || mesh.headDiameter) return;
    }
    if (mesh.lead && !isScrew) reject(toTranslate("Only a screw has a lead; mesh \"%1\" is none."), "/lead");
    if (kind.slides) checkTravel(mesh, at);
    if (!kind.touches && mesh.friction)
      reject(toTranslate("Mesh \"%1\" has no teeth that slide: state its `efficiency`, not a `friction`."),
             "/friction");
    if (!kind.touches && mesh.pitchPoint && !isRack)
      reject(toTranslate("Mesh \"%1\" is a belt or pins, which have no pitch point: leave it out."),
             "/pitchPoint");
    for (const auto& [length, member] :
         {std::pair(&mesh.pitch, "/pitch"), std::pair(&mesh.tailDiameter, "/tailDiameter"),
          std::pair(&mesh.headDiameter, "/headDiameter")}) {
      if (*length && (*length)->value() <= 0)
        reject(toTranslate("Pitch and running diameters of belt \"%1\" are above 0."), member);
    }
    if (mesh.tailDiameter.has_value() != mesh.headDiameter.has_value()) {
      reject(toTranslate("Belt \"%1\" has teeth at both ends, or running diameters at both."),
             mesh.tailDiameter ? "/headDiameter" : "/tailDiameter");
    } else if (!statesTeeth(mesh)) {
      const auto weights = weightsWithoutTeeth(mesh);
      if (!weights) {
        reject(toTranslate("The running diameters of belt \"%1\" are in the ratio of two whole numbers up to "
                           "100,000: give them with fewer digits."),
               "/headDiameter");
      } else if (static_cast<long long>(mesh.tailTeeth) * weights->second !=
                 static_cast<long long>(mesh.headTeeth) * weights->first) {
        reject(toTranslate("Pins turn 1 : 1 and belts with running diameters in their ratio; mesh \"%1\" "
                           "states other teeth: leave them out."),
               "/tailTeeth");
      }
    }
  }

  void wheelOf(const GearMesh& mesh, const std::optional<WheelId>& wheel, LinkId link,
               const std::string& pointer) {
    if (!wheel) return;
    reference(mesh.id, *wheel, m_wheels, pointer);
    const auto found = m_linkOfWheel.find(*wheel);
    if (found == m_linkOfWheel.end() || found->second == link) return;
    if (m_links.contains(link.atom()) && m_links.contains(found->second.atom())) {
      add(Code::schema,
          translated("Mesh \"%1\" is on link \"%2\", but its wheel \"%3\" is on link \"%4\".",
                     {mesh.id.text(), link.text(), wheel->text(), found->second.text()}),
          {mesh.id, *wheel}, pointer);
    }
  }

  void checkWheels() {
    for (std::size_t i = 0; i < m_mechanism.wheels.size(); ++i) {
      const Wheel& wheel = m_mechanism.wheels[i];
      reference(wheel.id, wheel.link, m_links, pointerTo(ElementKind::wheel, i) + "/link");
    }
  }

  void checkInputs() {
    if (!m_mechanism.inputs) return;
    Known seen;
    for (std::size_t i = 0; i < m_mechanism.inputs->size(); ++i) {
      const JointId joint = (*m_mechanism.inputs)[i].joint;
      const std::string at = "/inputs/" + std::to_string(i) + "/joint";
      if (!m_joints.contains(joint.atom())) {
        add(Code::unknownId,
            translated("%1 names \"%2\", but %3 has no such id.", {"inputs", joint.text(), "turningJoints"}),
            {joint}, at);
      } else if (!seen.insert(joint.atom()).second) {
        add(Code::duplicateId, translated("The joint \"%1\" occurs twice in %2.", {joint.text(), "inputs"}),
            {joint}, at);
      }
    }
  }

  void checkCouplings() {
    for (std::size_t i = 0; i < m_mechanism.couplings.size(); ++i) {
      const ShiftElement& coupling = m_mechanism.couplings[i];
      const std::string at = pointerTo(ElementKind::coupling, i);
      const bool isBrake = coupling.kind == ShiftElementKind::brake;
      for (std::size_t k = 0; k < coupling.links.size(); ++k) {
        reference(coupling.id, coupling.links[k], m_links,
                  at + (isBrake ? "/link" : "/links/" + std::to_string(k)));
      }
      const std::size_t wanted = isBrake ? 1 : 2;
      if (coupling.links.size() != wanted) {
        add(Code::schema,
            coupling.kind == ShiftElementKind::freewheel
                ? translated("A freewheel names two links.")
                : translated("A brake names one link, a clutch two."),
            {coupling.id}, at + (isBrake ? "/link" : "/links"));
      } else if (wanted == 2 && coupling.links[0] == coupling.links[1]) {
        add(Code::selfJoint,
            coupling.kind == ShiftElementKind::freewheel
                ? translated("Freewheel \"%1\" ties link \"%2\" to itself.",
                             {coupling.id.text(), coupling.links[0].text()})
                : translated("Clutch \"%1\" ties link \"%2\" to itself.",
                             {coupling.id.text(), coupling.links[0].text()}),
            {coupling.id, coupling.links[0]}, at + "/links/1");
      }
    }
  }

  void checkStates() {
    Known names;
    for (std::size_t i = 0; i < m_mechanism.states.size(); ++i) {
      const ShiftState& state = m_mechanism.states[i];
      const ElementId owner(ElementKind::state, InternedString(state.name));
      const std::string at = pointerTo(ElementKind::state, i);
      if (!names.insert(owner.id).second) {
        add(Code::duplicateId, translated("The name \"%1\" occurs twice in %2.", {state.name, "states"}),
            {owner}, at + "/name");
      }
      for (std::size_t k = 0; k < state.engaged.size(); ++k) {
        reference(owner, state.engaged[k], m_couplings, at + "/engaged/" + std::to_string(k));
        const ShiftElement* const coupling = m_mechanism.find(state.engaged[k]);
        if (coupling != nullptr && coupling->kind == ShiftElementKind::freewheel) {
          add(Code::schema,
              translated("State \"%1\" engages freewheel \"%2\", which locks by itself: leave it out.",
                         {state.name, state.engaged[k].text()}),
              {owner, state.engaged[k]}, at + "/engaged/" + std::to_string(k));
        }
      }
      if (state.direction && state.direction->exact().abs() != Rational(1)) {
        add(Code::schema, translated("The direction of a state is 1 or -1."), {owner}, at + "/direction");
      }
      if (state.drive) reference(owner, *state.drive, m_links, at + "/drive");
      if (state.driven) reference(owner, *state.driven, m_links, at + "/driven");
    }
  }

  void checkEngaged() {
    Known seen;
    for (std::size_t i = 0; i < m_mechanism.engaged.size(); ++i) {
      const ShiftElementId id = m_mechanism.engaged[i];
      const std::string at = "/engaged/" + std::to_string(i);
      if (!m_couplings.contains(id.atom())) {
        add(Code::unknownId, translated("There is no \"%1\" in %2.", {id.text(), "couplings"}), {id}, at);
      } else if (!seen.insert(id.atom()).second) {
        add(Code::duplicateId, translated("Coupling \"%1\" is listed twice in %2.", {id.text(), "engaged"}),
            {id}, at);
      }
    }
  }

  void checkCamera() {
    const std::optional<ViewCamera>& camera = m_mechanism.view.camera;
    if (camera && camera->distance <= 0)
      add(Code::schema, translated("The distance of the camera has to be above 0."), {},
          "/view/camera/distance");
  }

  const Mechanism& m_mechanism;
  Diagnostics m_diagnostics;
  Known m_links;
  Known m_axes;
  Known m_joints;
  Known m_meshes;
  Known m_wheels;
  Known m_couplings;
  Known m_notes;
  std::unordered_map<WheelId, LinkId> m_linkOfWheel;
};

/// A forest of links (by position) that grows by turning joints: sets while it grows, parents afterwards.
class Forest {
 public:
  explicit Forest(std::size_t links) : m_sets(links), m_edges(links) {}

  [[nodiscard]] bool isTied(std::size_t a, std::size_t b) const { return m_sets.areJoined(a, b); }

  /// False where the two hang together already: then the joint would close a loop.
  bool join(std::size_t a, std::size_t b, std::size_t joint) {
    if (m_sets.areJoined(a, b)) return false;
    m_sets.join(a, b);
    m_edges[a].push_back({b, joint});
    m_edges[b].push_back({a, joint});
    return true;
  }

  /// Hangs every tree on its first link; join() nothing more. Cost: O(links).
  void hang() {
    constexpr auto kNobody = static_cast<std::size_t>(-1);
    m_parent.assign(m_edges.size(), {kNobody, 0});
    m_depth.assign(m_edges.size(), 0);
    std::vector<std::size_t> queue;
    for (std::size_t first = 0; first < m_edges.size(); ++first) {
      if (m_parent[first].link != kNobody) continue;
      m_parent[first].link = first;
      queue.assign(1, first);
      for (std::size_t at = 0; at < queue.size(); ++at) {
        for (const Edge& edge : m_edges[queue[at]]) {
          if (m_parent[edge.link].link != kNobody) continue;
          m_parent[edge.link] = {queue[at], edge.joint};
          m_depth[edge.link] = m_depth[queue[at]] + 1;
          queue.push_back(edge.link);
        }
      }
    }
  }

  /// The joints between two links of one tree, from `from` to `to`. Cost: O(their number).
  [[nodiscard]] std::vector<std::size_t> path(std::size_t from, std::size_t to) const {
    std::vector<std::size_t> joints;
    std::vector<std::size_t> last;
    while (from != to) {
      const bool climbsFrom = m_depth[from] >= m_depth[to];
      std::size_t& link = climbsFrom ? from : to;
      (climbsFrom ? joints : last).push_back(m_parent[link].joint);
      link = m_parent[link].link;
    }
    joints.insert(joints.end(), last.rbegin(), last.rend());
    return joints;
  }

 private:
  struct Edge {
    std::size_t link = 0;
    std::size_t joint = 0;
  };
  DisjointSets m_sets;
  std::vector<std::vector<Edge>> m_edges;
  std::vector<Edge> m_parent;
  std::vector<std::size_t> m_depth;
};

constexpr std::size_t kMaxNamesInASentence = 8;

/// A drawing has few loops, all of which are named; a hostile file may have 50,000 of 50,000 joints each.
constexpr std::size_t kMaxNamedInLoops = 1'000'000;

/// `path`: the joints that the closing one makes a loop with; empty where too many were named already.
Diagnostic loopDiagnostic(const Mechanism& mechanism, std::size_t closing,
                          const std::vector<std::size_t>& path) {
  const TurningJoint& last = mechanism.turningJoints[closing];
  std::vector<ElementId> elements{last.id};
  std::vector<std::string> names;
  bool oneAxis = true;
  for (const std::size_t joint : path) {
    const TurningJoint& other = mechanism.turningJoints[joint];
    elements.emplace_back(other.id);
    names.push_back(std::to_string(mechanism.jointLabel(static_cast<int>(joint))));
    oneAxis = oneAxis && other.axis == last.axis;
  }
  const std::string label = std::to_string(mechanism.jointLabel(static_cast<int>(closing)));
  std::string message = path.empty() ? translated("Turning joint %1 closes a loop.", {label})
                                     : translated("Turning joint %1 closes a loop with %2.",
                                                  {label, listed(names, kMaxNamesInASentence)});
  const bool isRedundant = oneAxis && !path.empty();
  message += ' ';
  message +=
      isRedundant
          ? translated("All of them turn about axis %1, so joint %2 is a redundant bearing: drop it.",
                       {last.axis.text(), label})
          : translated(
                "The turning joints have to be a tree: delete one of them, or draw a gear mesh instead.");
  Diagnostic result = makeDiagnostic(Code::turningLoop, std::move(message), std::move(elements));
  result.detail = isRedundant ? Detail::redundantBearing : Detail::turningCycle;
  return result;
}

}  // namespace

std::optional<std::string> limitsProblem(const JointLimits& limits) {
  const double low = limits.low ? limits.low->value() : -1;
  const double high = limits.high ? limits.high->value() : 1;
  if (low <= 0 && high >= 0 && low < high) return std::nullopt;
  return translated(
      "The limits of a joint are two angles from the reference pose, in degrees: the first at most 0, the "
      "second at least 0, and not both 0.");
}

Diagnostics wellFormedDiagnostics(const Mechanism& mechanism) {
  return WellFormedCheck(mechanism).run();
}

Diagnostics treeDiagnostics(const Mechanism& mechanism) {
  std::unordered_map<LinkId, std::size_t> position;
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) position.emplace(mechanism.links[i].id, i);

  Forest forest(mechanism.links.size());
  Diagnostics diagnostics;
  std::vector<std::size_t> closing;
  for (std::size_t j = 0; j < mechanism.turningJoints.size(); ++j) {
    const TurningJoint& joint = mechanism.turningJoints[j];
    const std::size_t tail = position.at(joint.tail);
    const std::size_t head = position.at(joint.head);
    if (!forest.join(tail, head, j)) closing.push_back(j);
  }
  if (!closing.empty()) forest.hang();
  std::size_t named = 0;
  for (const std::size_t j : closing) {
    const TurningJoint& joint = mechanism.turningJoints[j];
    std::vector<std::size_t> path;
    if (named < kMaxNamedInLoops) path = forest.path(position.at(joint.tail), position.at(joint.head));
    named += path.size();
    diagnostics.push_back(loopDiagnostic(mechanism, j, path));
  }

  std::vector<ElementId> loose;
  std::vector<std::string> labels;
  for (std::size_t i = 1; i < mechanism.links.size(); ++i) {
    if (forest.isTied(i, 0)) continue;
    loose.emplace_back(mechanism.links[i].id);
    labels.push_back(std::to_string(i));
  }
  if (!loose.empty()) {
    const bool one = loose.size() == 1;
    diagnostics.insert(
        diagnostics.begin(),
        makeDiagnostic(
            Code::disconnected,
            one ? translated(
                      "Link %1 is not tied to the ground by turning joints: draw a turning joint to it.",
                      {labels.front()})
                : translated(
                      "Links %1 are not tied to the ground by turning joints: draw a turning joint to them.",
                      {listed(labels, kMaxNamesInASentence)}),
            std::move(loose)));
  }
  return diagnostics;
}

}  // namespace geargraph
