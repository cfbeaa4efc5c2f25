#include "core/mechanism/model/link_edits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "core/foundations/base/disjoint_sets.h"
#include "core/foundations/base/position_index.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/base/triple.h"
#include "core/mechanism/model/arrow_flips.h"
#include "core/mechanism/model/fresh_ids.h"
#include "core/mechanism/model/link_colors.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/validate.h"

namespace geargraph {
namespace {

using Vector = ExactVector3;

Diagnostic unknown(const ElementId& element) {
  return {Code::unknownId,
          translated("There is no \"%1\" in %2.", {element.id.text(), listName(element.kind)}),
          {element},
          {},
          0,
          0};
}

Diagnostic rejection(Code code, std::string message, std::vector<ElementId> elements = {}) {
  return {code, std::move(message), std::move(elements), {}, 0, 0};
}

std::string label(const Mechanism& mechanism, const ElementId& element) {
  return labelOf(mechanism, element).value_or(element.id.text());
}

// --- exact vectors ---------------------------------------------------------------------------------------

Vector exactOf(const NumberTriple& triple) {
  return {triple[0].exact(), triple[1].exact(), triple[2].exact()};
}

bool isZeroVector(const Vector& v) {
  return v[0].isZero() && v[1].isZero() && v[2].isZero();
}

NumberTriple moved(const NumberTriple& point, const Vector& by) {
  NumberTriple result = point;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!by[i].isZero()) result[i] = Number(point[i].exact() + by[i]);
  }
  return result;
}

// --- the tree of turning joints --------------------------------------------------------------------------

/// The links by position as a rooted forest of turning joints; a joint that closes a loop is left out.
class JointForest {
 public:
  explicit JointForest(const Mechanism& mechanism)
      : m_parent(mechanism.links.size(), -1),
        m_joint(mechanism.links.size(), -1),
        m_depth(mechanism.links.size(), 0) {
    const PositionIndex<LinkTag> links(mechanism.links);
    std::vector<std::vector<std::pair<int, int>>> edges(mechanism.links.size());
    for (int j = 0; j < mechanism.t(); ++j) {
      const TurningJoint& joint = mechanism.turningJoints[static_cast<std::size_t>(j)];
      const int tail = links.positionOf(joint.tail);
      const int head = links.positionOf(joint.head);
      edges[static_cast<std::size_t>(tail)].emplace_back(head, j);
      edges[static_cast<std::size_t>(head)].emplace_back(tail, j);
    }
    for (int root = 0; root < static_cast<int>(edges.size()); ++root) {
      if (m_parent[static_cast<std::size_t>(root)] < 0) hangOn(root, edges);
    }
  }

  /// The joints (positions) between two links, from `from` to `to`; empty if they are not connected.
  [[nodiscard]] std::vector<int> path(int from, int to) const {
    std::vector<int> up;
    std::vector<int> down;
    while (from != to) {
      const bool climbs = depth(from) >= depth(to);
      int& link = climbs ? from : to;
      const int joint = m_joint[static_cast<std::size_t>(link)];
      if (joint < 0) return {};
      (climbs ? up : down).push_back(joint);
      link = m_parent[static_cast<std::size_t>(link)];
    }
    up.insert(up.end(), down.rbegin(), down.rend());
    return up;
  }
  /// The joint on which a link is carried, -1 for the root of a tree.
  [[nodiscard]] int carryingJoint(int link) const { return m_joint[static_cast<std::size_t>(link)]; }

 private:
  [[nodiscard]] int depth(int link) const { return m_depth[static_cast<std::size_t>(link)]; }

  void hangOn(int root, const std::vector<std::vector<std::pair<int, int>>>& edges) {
    std::vector<int> queue{root};
    m_parent[static_cast<std::size_t>(root)] = root;
    for (std::size_t at = 0; at < queue.size(); ++at) {
      const int link = queue[at];
      for (const auto& [next, joint] : edges[static_cast<std::size_t>(link)]) {
        if (m_parent[static_cast<std::size_t>(next)] >= 0) continue;
        m_parent[static_cast<std::size_t>(next)] = link;
        m_joint[static_cast<std::size_t>(next)] = joint;
        m_depth[static_cast<std::size_t>(next)] = depth(link) + 1;
        queue.push_back(next);
      }
    }
  }

  std::vector<int> m_parent;
  std::vector<int> m_joint;
  std::vector<int> m_depth;
};

bool isOnOneAxis(const Mechanism& mechanism, const std::vector<int>& path) {
  return std::all_of(path.begin(), path.end(), [&](int joint) {
    return mechanism.turningJoints[static_cast<std::size_t>(joint)].axis ==
           mechanism.turningJoints[static_cast<std::size_t>(path.front())].axis;
  });
}

/// The meshes whose two wheels turn about one axis: the links between them are joined about that axis only.
/// Cost: O(t + c), and the joints of the link of a mesh that has fewer.
std::set<MeshId> coaxialMeshes(const Mechanism& mechanism) {
  const PositionIndex<LinkTag> links(mechanism.links);
  const PositionIndex<AxisTag> axes(mechanism.axes);
  DisjointSets groups;  // of links about one axis
  std::size_t next = 0;
  std::vector<std::unordered_map<int, std::size_t>> groupAbout(mechanism.links.size());  // by axis
  const auto groupOf = [&](LinkId link, int axis) {
    auto& known = groupAbout[static_cast<std::size_t>(links.positionOf(link))];
    const auto [found, isNew] = known.emplace(axis, next);
    if (isNew) {
      groups.add();
      ++next;
    }
    return found->second;
  };
  for (const TurningJoint& joint : mechanism.turningJoints) {
    const int axis = axes.positionOf(joint.axis);
    groups.join(groupOf(joint.tail, axis), groupOf(joint.head, axis));
  }
  std::set<MeshId> found;
  for (const GearMesh& mesh : mechanism.gearMeshes) {
    const auto* fewer = &groupAbout[static_cast<std::size_t>(links.positionOf(mesh.tail))];
    const auto* more = &groupAbout[static_cast<std::size_t>(links.positionOf(mesh.head))];
    if (fewer->size() > more->size()) std::swap(fewer, more);
    const bool isCoaxial = std::any_of(fewer->begin(), fewer->end(), [&](const auto& about) {
      const auto other = more->find(about.first);
      return other != more->end() && groups.areJoined(about.second, other->second);
    });
    if (isCoaxial) found.insert(mesh.id);
  }
  return found;
}

// --- a weld ----------------------------------------------------------------------------------------------

class Weld {
 public:
  Weld(Mechanism mechanism, LinkId kept, LinkId other)
      : m_result(std::move(mechanism)), m_before(m_result), m_kept(kept), m_other(other) {}

  Expected<Mechanism> run() {
    if (auto why = whyNot()) return *std::move(why);
    const LinkColors colors(m_result);
    if (auto why = settleJoints()) return *std::move(why);
    rename();
    dropBetween();
    if (auto why = checkAxes()) return *std::move(why);
    mergeLink();
    colors.keepIn(m_result);
    return std::move(m_result);
  }

 private:
  using Why = std::optional<Diagnostic>;

  [[nodiscard]] bool isGround() const { return m_kept == m_before.links.front().id; }

  [[nodiscard]] Why whyNot() const {
    for (const GearMesh& mesh : m_before.gearMeshes) {
      const bool between =
          (mesh.tail == m_kept && mesh.head == m_other) || (mesh.tail == m_other && mesh.head == m_kept);
      if (!between) continue;
      return rejection(
          Code::selfJoint,
          translated("Links %1 and %2 mesh with each other in mesh %3: delete it before you weld them.",
                     {label(m_before, m_kept), label(m_before, m_other), label(m_before, mesh.id)}),
          {mesh.id, m_kept, m_other});
    }
    for (const LinkId link : {m_kept, m_other}) {
      if (!m_before.find(link)->mass) continue;
      return rejection(
          Code::schema,
          translated("The mass of link %1 is stated, and would be that of a part only: remove it "
                     "before you weld the link.",
                     {label(m_before, link)}),
          {link});
    }
    if (isGround() && isLoaded()) {
      return rejection(
          Code::schema,
          translated("Loads or balances act on this link, and the ground can have none: remove them first."),
          {m_other});
    }
    return std::nullopt;
  }

  [[nodiscard]] bool isLoaded() const {
    const bool loaded = std::any_of(m_before.loads.begin(), m_before.loads.end(),
                                    [&](const Load& load) { return linkOf(load) == m_other; });
    if (loaded || !m_before.balances) return loaded;
    return std::any_of(m_before.balances->begin(), m_before.balances->end(),
                       [&](const HoldingTorque& balance) {
                         const auto* onLink = std::get_if<HoldingTorque::OnLink>(&balance.at);
                         return onLink != nullptr && onLink->link == m_other;
                       });
  }

  /// Takes the joint out that would close a loop.
  Why settleJoints() {
    const PositionIndex<LinkTag> links(m_before.links);
    const std::vector<int> path =
        JointForest(m_before).path(links.positionOf(m_kept), links.positionOf(m_other));
    if (path.empty()) return std::nullopt;
    const TurningJoint goes = m_before.turningJoints[static_cast<std::size_t>(path.back())];
    const TurningJoint* stays = nullptr;
    if (path.size() == 2) {
      stays = &m_before.turningJoints[static_cast<std::size_t>(path.front())];
    } else if (path.size() > 2 && !isOnOneAxis(m_before, path)) {
      return loop(goes);
    }
    if (stays != nullptr) {
      const AxisId axis = stays->axis;
      if (auto why = moveJoint(goes, *stays)) return why;
      if (goes.axis != axis) {
        if (auto why = joinAxes(axis, goes.axis, carrierOf(goes))) return why;
      }
    } else if (loadIn(goes.id)) {
      return rejection(Code::schema,
                       translated("A load or balance is in joint %1, which the weld takes away: remove it "
                                  "first.",
                                  {label(m_before, goes.id)}),
                       {goes.id});
    }
    std::erase_if(m_result.turningJoints, [&](const TurningJoint& joint) { return joint.id == goes.id; });
    dropInput(goes.id);
    dropAxisIfUnused(goes.axis);
    return std::nullopt;
  }

  [[nodiscard]] Diagnostic loop(const TurningJoint& goes) const {
    Diagnostic why = rejection(
        Code::turningLoop,
        translated("Links %1 and %2 cannot be one: it would turn about several axes. Links are welded whose "
                   "joints can lie on one axis.",
                   {label(m_before, m_kept), label(m_before, m_other)}),
        {m_kept, m_other, goes.id});
    why.detail = Detail::turningCycle;
    return why;
  }

  [[nodiscard]] LinkId carrierOf(const TurningJoint& joint) const {
    return joint.tail == m_other ? joint.head : joint.tail;
  }

  [[nodiscard]] bool loadIn(JointId joint) const {
    const bool loaded = std::any_of(m_before.loads.begin(), m_before.loads.end(),
                                    [&](const Load& load) { return jointOf(load) == joint; });
    if (loaded || !m_before.balances) return loaded;
    return std::any_of(m_before.balances->begin(), m_before.balances->end(),
                       [&](const HoldingTorque& balance) {
                         const auto* at = std::get_if<JointId>(&balance.at);
                         return at != nullptr && *at == joint;
                       });
  }

  TurningJoint& jointOfResult(JointId id) {
    return *std::find_if(m_result.turningJoints.begin(), m_result.turningJoints.end(),
                         [&](const TurningJoint& joint) { return joint.id == id; });
  }

  /// Input, limits, loads and balances of the joint that goes become those of the one that stays.
  Why moveJoint(const TurningJoint& goes, const TurningJoint& stays) {
    const bool alike = (goes.head == m_other) == (stays.head == m_kept);
    TurningJoint& into = jointOfResult(stays.id);
    const JointLimits limits = alike ? goes.limits : opposite(goes.limits);
    if (limits.low && (!into.limits.low || into.limits.low->exact() < limits.low->exact()))
      into.limits.low = limits.low;
    if (limits.high && (!into.limits.high || limits.high->exact() < into.limits.high->exact()))
      into.limits.high = limits.high;
    if (limitsProblem(into.limits)) {
      return rejection(Code::schema,
                       translated("The limits of joints %1 and %2 leave the welded link no angle to turn: "
                                  "change them first.",
                                  {label(m_before, stays.id), label(m_before, goes.id)}),
                       {stays.id, goes.id});
    }
    for (Load& load : m_result.loads) {
      auto* torque = std::get_if<JointTorque>(&load.action);
      if (torque == nullptr || torque->joint != goes.id) continue;
      torque->joint = stays.id;
      if (!alike) torque->torque = Number(-torque->torque.exact());
    }
    moveBalance(goes.id, stays.id);
    moveInput(goes.id, stays.id, alike);
    return std::nullopt;
  }

  void moveBalance(JointId from, JointId to) {
    if (!m_result.balances) return;
    auto& balances = *m_result.balances;
    const auto at = [&](JointId joint) {
      return std::find_if(balances.begin(), balances.end(), [&](const HoldingTorque& balance) {
        const auto* id = std::get_if<JointId>(&balance.at);
        return id != nullptr && *id == joint;
      });
    };
    const auto moved = at(from);
    if (moved == balances.end()) return;
    if (at(to) != balances.end()) {
      balances.erase(moved);
    } else {
      moved->at = to;
    }
  }

  void moveInput(JointId from, JointId to, bool alike) {
    if (!m_result.inputs) return;
    auto& inputs = *m_result.inputs;
    const auto at = [&](JointId joint) {
      return std::find_if(inputs.begin(), inputs.end(),
                          [&](const Input& input) { return input.joint == joint; });
    };
    const auto moved = at(from);
    if (moved == inputs.end() || at(to) != inputs.end()) return;
    moved->joint = to;
    if (!alike) moved->speed = Number(-moved->speed.exact());
  }

  void dropInput(JointId joint) {
    if (!m_result.inputs) return;
    std::erase_if(*m_result.inputs, [&](const Input& input) { return input.joint == joint; });
    if (m_result.inputs->empty()) m_result.inputs.reset();
  }

  // --- axes -----------------------------------------------------------------------------------------------

  Axis& axisOfResult(AxisId id) {
    return *std::find_if(m_result.axes.begin(), m_result.axes.end(),
                         [&](const Axis& axis) { return axis.id == id; });
  }

  /// All that turns about `goes` turns about `stays`. `carrier`: the link that both are axes of.
  Why joinAxes(AxisId stays, AxisId goes, LinkId carrier) {
    Axis& into = axisOfResult(stays);
    const Axis from = axisOfResult(goes);
    const bool isIntoPlaced = into.point || into.direction;
    const bool isFromPlaced = from.point || from.direction;
    if (isIntoPlaced && isFromPlaced) {
      if (auto why = bringTogether(into, from, carrier)) return why;
    } else if (isFromPlaced) {
      into.point = from.point;
      into.direction = from.direction;
    }
    into.pinned = into.pinned || from.pinned;
    takeEarlierPlace(stays, goes);
    for (TurningJoint& joint : m_result.turningJoints) {
      if (joint.axis == goes) joint.axis = stays;
    }
    forEachLoadAxis(m_result, [&](std::optional<AxisId>& axis) {
      if (axis == goes) axis = stays;
    });
    return std::nullopt;
  }

  /// The axis that stays takes the place of the other one in the list, if that is before its own: axes
  /// without a place are placed in this order, and whichever link stays the train is then laid out alike.
  void takeEarlierPlace(AxisId stays, AxisId goes) {
    const auto at = [&](AxisId id) {
      return std::find_if(m_result.axes.begin(), m_result.axes.end(),
                          [&](const Axis& axis) { return axis.id == id; });
    };
    if (at(goes) < at(stays)) std::rotate(at(goes), at(stays), at(stays) + 1);
  }

  /// Moves what is connected with the other link, so that its axis `from` lies on `into`.
  Why bringTogether(const Axis& into, const Axis& from, LinkId carrier) {
    if (into.direction && from.direction) {
      const Vector a = exactOf(*into.direction);
      const Vector b = exactOf(*from.direction);
      if (!isZeroVector(cross(a, b)) || dot(a, b).sign() < 0) {
        return axesRejection(
            toTranslate(
                "Axes %1 and %2 have different directions, so that links %3 and %4 cannot be one: lay "
                "one axis along the other first."),
            into, from);
      }
    }
    if (!into.point || !from.point) return std::nullopt;
    const Vector a = exactOf(*into.point);
    const Vector b = exactOf(*from.point);
    Vector by = a - b;
    const std::optional<NumberTriple>& line = into.direction ? into.direction : from.direction;
    Rational along = 0;
    if (line) {
      const Vector direction = exactOf(*line);
      along = dot(by, direction) / dot(direction, direction);
      by = by - along * direction;
      moveOffsets(from, along, dot(direction, direction));
    }
    if (isZeroVector(by)) return std::nullopt;
    const std::set<LinkId> side = sideOfOther(carrier, from.id);
    if (side.contains(m_kept)) {
      return axesRejection(
          toTranslate(
              "Axes %1 and %2 are in different places of one train, so that links %3 and %4 cannot be "
              "one: lay one axis on the other first."),
          into, from);
    }
    moveSide(side, from.id, by);
    return std::nullopt;
  }

  Why axesRejection(const char* sentence, const Axis& into, const Axis& from) const {
    Diagnostic why =
        rejection(Code::turningLoop,
                  filled(translated(sentence),
                         {into.id.text(), from.id.text(), label(m_before, m_kept), label(m_before, m_other)}),
                  {into.id, from.id, m_kept, m_other});
    why.detail = Detail::turningCycle;
    return why;
  }

  /// Bearings keep their places along the line, whose point becomes another one.
  void moveOffsets(const Axis& from, const Rational& along, const Rational& squaredLength) {
    if (along.isZero()) return;
    const Rational length =
        squaredLength.squareRoot().value_or(Rational::fromDouble(std::sqrt(squaredLength.toDouble())));
    for (TurningJoint& joint : m_result.turningJoints) {
      if (joint.axis == from.id) joint.offset = Number(joint.offset.exact() - along * length);
    }
  }

  /// The links that hang together with the other one but for the carrier: by joints, meshes, and the axis.
  [[nodiscard]] std::set<LinkId> sideOfOther(LinkId carrier, AxisId axis) const {
    const PositionIndex<LinkTag> links(m_before.links);
    DisjointSets groups(m_before.links.size());
    const LinkId ground = m_before.links.front().id;
    const auto position = [&](LinkId link) { return static_cast<std::size_t>(links.positionOf(link)); };
    const auto join = [&](LinkId a, LinkId b) {
      if (a == carrier || b == carrier || a == ground || b == ground) return;
      groups.join(position(a), position(b));
    };
    for (const TurningJoint& joint : m_before.turningJoints) {
      join(joint.tail, joint.head);
      if (joint.axis != axis) continue;
      join(joint.tail, m_other);
      join(joint.head, m_other);
    }
    for (const GearMesh& mesh : m_before.gearMeshes) join(mesh.tail, mesh.head);
    std::set<LinkId> side;
    for (const Link& link : m_before.links) {
      if (groups.root(position(link.id)) == groups.root(position(m_other))) side.insert(link.id);
    }
    return side;
  }

  void moveSide(const std::set<LinkId>& side, AxisId but, const Vector& by) {
    std::set<AxisId> axes;
    for (const TurningJoint& joint : m_result.turningJoints) {
      if (joint.axis != but && (side.contains(joint.tail) || side.contains(joint.head)))
        axes.insert(joint.axis);
    }
    for (Axis& axis : m_result.axes) {
      if (axes.contains(axis.id) && axis.point) axis.point = moved(*axis.point, by);
    }
    for (GearMesh& mesh : m_result.gearMeshes) {
      const bool isOn = side.contains(mesh.tail) || side.contains(mesh.head);
      if (isOn && mesh.pitchPoint) mesh.pitchPoint = moved(*mesh.pitchPoint, by);
    }
    for (Load& load : m_result.loads) {
      auto* force = std::get_if<LinkForce>(&load.action);
      if (force != nullptr && side.contains(force->link)) force->point = moved(force->point, by);
    }
    for (Link& link : m_result.links) {
      if (!side.contains(link.id)) continue;
      for (LinkShape& shape : link.shapes)
        shape.position = moved(shape.position.value_or(NumberTriple{}), by);
    }
  }

  void dropAxisIfUnused(AxisId axis) {
    bool used = std::any_of(m_result.turningJoints.begin(), m_result.turningJoints.end(),
                            [&](const TurningJoint& joint) { return joint.axis == axis; });
    forEachLoadAxis(m_result, [&](std::optional<AxisId>& each) { used = used || each == axis; });
    if (!used) std::erase_if(m_result.axes, [&](const Axis& each) { return each.id == axis; });
  }

  /// No pair of wheels may come to lie on one axis.
  [[nodiscard]] Why checkAxes() const {
    const std::set<MeshId> before = coaxialMeshes(m_before);
    for (const MeshId mesh : coaxialMeshes(m_result)) {
      if (before.contains(mesh)) continue;
      Diagnostic why = rejection(
          Code::turningLoop,
          translated("Links %1 and %2 cannot be one: both wheels of mesh %3 would turn about one axis.",
                     {label(m_before, m_kept), label(m_before, m_other), label(m_before, mesh)}),
          {m_kept, m_other, mesh});
      why.detail = Detail::turningCycle;
      return why;
    }
    return std::nullopt;
  }

  // --- all that names the link ----------------------------------------------------------------------------

  void become(LinkId& link) const {
    if (link == m_other) link = m_kept;
  }

  void rename() {
    for (TurningJoint& joint : m_result.turningJoints) {
      become(joint.tail);
      become(joint.head);
    }
    for (GearMesh& mesh : m_result.gearMeshes) {
      become(mesh.tail);
      become(mesh.head);
    }
    for (Wheel& wheel : m_result.wheels) become(wheel.link);
    for (ShiftElement& coupling : m_result.couplings) {
      for (LinkId& link : coupling.links) become(link);
    }
    for (ShiftState& state : m_result.states) {
      if (state.drive) become(*state.drive);
      if (state.driven) become(*state.driven);
      if (state.driven && state.drive == state.driven) state.driven.reset();
    }
    for (Load& load : m_result.loads) {
      if (auto* torque = std::get_if<LinkTorque>(&load.action)) become(torque->link);
      if (auto* force = std::get_if<LinkForce>(&load.action)) become(force->link);
    }
    if (m_result.balances) {
      for (HoldingTorque& balance : *m_result.balances) {
        if (auto* onLink = std::get_if<HoldingTorque::OnLink>(&balance.at)) become(onLink->link);
      }
      dropEqualBalances();
    }
  }

  void dropEqualBalances() {
    std::vector<HoldingTorque> kept;
    for (HoldingTorque& balance : *m_result.balances) {
      const bool isThere =
          std::any_of(kept.begin(), kept.end(), [&](const auto& each) { return each.at == balance.at; });
      if (!isThere) kept.push_back(std::move(balance));
    }
    m_result.balances = std::move(kept);
  }

  /// Couplings between the two, those that now hold the ground, and meshes that are twice there.
  void dropBetween() {
    for (ShiftElement& coupling : m_result.couplings) {
      // A clutch to the frame is a brake.
      const bool isClutch = coupling.kind == ShiftElementKind::clutch && coupling.links.size() == 2;
      if (!isGround() || !isClutch || coupling.links[0] == coupling.links[1]) continue;
      if (coupling.links[0] != m_kept && coupling.links[1] != m_kept) continue;
      coupling.kind = ShiftElementKind::brake;
      std::erase(coupling.links, m_kept);
    }
    std::unordered_set<InternedString> gone;
    std::erase_if(m_result.couplings, [&](const ShiftElement& coupling) {
      const bool isNone = coupling.links.size() == 1
                              ? isGround() && coupling.links[0] == m_kept
                              : coupling.links.size() == 2 && coupling.links[0] == coupling.links[1];
      if (isNone) gone.insert(coupling.id.atom());
      return isNone;
    });
    const auto isGone = [&](ShiftElementId id) { return gone.contains(id.atom()); };
    std::erase_if(m_result.engaged, isGone);
    for (ShiftState& state : m_result.states) std::erase_if(state.engaged, isGone);
    dropEqualMeshes();
  }

  void dropEqualMeshes() {
    std::vector<GearMesh> seen;  // meshes of the merged link
    std::erase_if(m_result.gearMeshes, [&](const GearMesh& mesh) {
      if (mesh.tail != m_kept && mesh.head != m_kept) return false;
      GearMesh nameless = mesh;
      nameless.id = {};
      GearMesh other = nameless;
      flip(other);
      const bool isThere = std::find(seen.begin(), seen.end(), nameless) != seen.end() ||
                           std::find(seen.begin(), seen.end(), other) != seen.end();
      if (!isThere) seen.push_back(std::move(nameless));
      return isThere;
    });
  }

  void mergeLink() {
    const auto at = [&](LinkId id) {
      return std::find_if(m_result.links.begin(), m_result.links.end(),
                          [&](const Link& link) { return link.id == id; });
    };
    Link other = std::move(*at(m_other));
    m_result.links.erase(at(m_other));
    Link& kept = *at(m_kept);
    if (kept.name.empty()) kept.name = std::move(other.name);
    kept.pinned = kept.pinned || other.pinned;
    std::move(other.shapes.begin(), other.shapes.end(), std::back_inserter(kept.shapes));
    m_result.view.nodes.erase(m_other);
    m_result.view.ttNodes.erase(m_other);
    m_result.view.colors.erase(m_other);
  }

  Mechanism m_result;
  const Mechanism m_before;
  LinkId m_kept;
  LinkId m_other;
};

bool isOf(LinkId link, const TurningJoint& joint) {
  return joint.tail == link || joint.head == link;
}
bool isOf(LinkId link, const GearMesh& mesh) {
  return mesh.tail == link || mesh.head == link;
}
bool isOf(LinkId link, const ShiftElement& coupling) {
  return std::find(coupling.links.begin(), coupling.links.end(), link) != coupling.links.end();
}

/// Is this joint, mesh or coupling one of the link? Cost: O(the length of its list).
bool isOf(const Mechanism& mechanism, LinkId link, const ElementId& element) {
  const auto isItsOwn = [&](const auto* found) { return found != nullptr && isOf(link, *found); };
  switch (element.kind) {
    case ElementKind::turningJoint:
      return isItsOwn(mechanism.find(JointId(element.id)));
    case ElementKind::gearMesh:
      return isItsOwn(mechanism.find(MeshId(element.id)));
    case ElementKind::coupling:
      return isItsOwn(mechanism.find(ShiftElementId(element.id)));
    default:
      return false;
  }
}

bool exists(const Mechanism& mechanism, const ElementId& element) {
  switch (element.kind) {
    case ElementKind::turningJoint:
      return mechanism.find(JointId(element.id)) != nullptr;
    case ElementKind::gearMesh:
      return mechanism.find(MeshId(element.id)) != nullptr;
    case ElementKind::coupling:
      return mechanism.find(ShiftElementId(element.id)) != nullptr;
    default:
      return true;  // told as one that is no part of the link
  }
}

/// The joint on which a link is carried towards the ground; null if there is none.
const TurningJoint* carryingJointOf(const Mechanism& mechanism, LinkId link) {
  const PositionIndex<LinkTag> links(mechanism.links);
  const int joint = JointForest(mechanism).carryingJoint(links.positionOf(link));
  return joint < 0 ? nullptr : &mechanism.turningJoints[static_cast<std::size_t>(joint)];
}

/// Gives the moved meshes wheels of the new link: those that only they name go along, others are copied.
void moveWheels(Mechanism& mechanism, LinkId from, LinkId to, const std::unordered_set<ElementId>& moved) {
  std::map<WheelId, WheelId> wheels;
  std::set<WheelId> left;
  const auto forEachEnd = [&](bool isMoved, const auto& use) {
    for (GearMesh& mesh : mechanism.gearMeshes) {
      if (moved.contains(mesh.id) != isMoved) continue;
      if (mesh.tailWheel) use(*mesh.tailWheel);
      if (mesh.headWheel) use(*mesh.headWheel);
    }
  };
  forEachEnd(false, [&](const WheelId& wheel) { left.insert(wheel); });
  forEachEnd(true, [&](WheelId& wheel) {
    const auto found = std::find_if(mechanism.wheels.begin(), mechanism.wheels.end(),
                                    [&](const Wheel& each) { return each.id == wheel; });
    if (const auto known = wheels.find(wheel); known != wheels.end()) {
      wheel = known->second;
    } else if (found != mechanism.wheels.end() && found->link == from) {
      const WheelId before = wheel;
      if (left.contains(before)) {
        Wheel copy = *found;
        for (int i = 2; mechanism.find(copy.id) != nullptr; ++i)
          copy.id = WheelId(before.text() + "." + std::to_string(i));
        copy.link = to;
        wheel = copy.id;
        mechanism.wheels.push_back(std::move(copy));
      } else {
        found->link = to;
      }
      wheels.emplace(before, wheel);
    }
  });
}

}  // namespace

Expected<Mechanism> withLinksMerged(Mechanism mechanism, LinkId kept, LinkId other) {
  for (const LinkId link : {kept, other}) {
    if (mechanism.find(link) == nullptr) return unknown(link);
  }
  if (kept == other)
    return rejection(Code::selfJoint, translated("A weld needs two different links."), {kept});
  if (other == mechanism.links.front().id) std::swap(kept, other);
  return Weld(std::move(mechanism), kept, other).run();
}

Expected<Mechanism> withLinkSplit(Mechanism mechanism, LinkId link, std::span<const ElementId> moving,
                                  std::optional<CanvasPoint> at) {
  const Link* const before = mechanism.find(link);
  if (before == nullptr) return unknown(link);
  if (link == mechanism.links.front().id) {
    return rejection(Code::schema,
                     translated("The ground cannot be split: nothing says about which axis its part turns."),
                     {link});
  }
  const std::unordered_set<ElementId> moved(moving.begin(), moving.end());
  for (const ElementId& element : moving) {
    if (!exists(mechanism, element)) return unknown(element);
    if (isOf(mechanism, link, element)) continue;
    return rejection(Code::schema,
                     translated("\"%1\" is no joint, mesh or coupling of link %2.",
                                {element.id.text(), label(mechanism, link)}),
                     {element, link});
  }
  const TurningJoint* const carrying = carryingJointOf(mechanism, link);
  if (carrying == nullptr) {
    return rejection(
        Code::schema,
        translated("Link %1 turns on no other link, so that its parts have no axis: draw its joint first.",
                   {label(mechanism, link)}),
        {link});
  }
  // The joint that carries the link is there for both parts.
  std::size_t goes = 0;
  std::size_t stays = 0;
  const auto count = [&](const auto& list) {
    for (const auto& each : list) {
      if (isOf(link, each) && ElementId(each.id) != ElementId(carrying->id))
        ++(moved.contains(each.id) ? goes : stays);
    }
  };
  count(mechanism.turningJoints);
  count(mechanism.gearMeshes);
  count(mechanism.couplings);
  if (goes == 0 || stays == 0) {
    return rejection(Code::schema,
                     translated("To split link %1, choose some of its joints and meshes, and leave others: "
                                "the new link takes those that you choose.",
                                {label(mechanism, link)}),
                     {link});
  }

  const LinkColors colors(mechanism);
  const std::vector<std::string> ids = freshIds(mechanism, 2);
  const LinkId part(ids[0]);
  TurningJoint joint = *carrying;
  joint.id = JointId(ids[1]);
  joint.limits = {};
  joint.unknown = {};
  if (!moved.contains(carrying->id)) (joint.tail == link ? joint.tail : joint.head) = part;
  const auto move = [&](LinkId& end) {
    if (end == link) end = part;
  };
  for (TurningJoint& each : mechanism.turningJoints) {
    if (!moved.contains(each.id)) continue;
    move(each.tail);
    move(each.head);
  }
  for (GearMesh& mesh : mechanism.gearMeshes) {
    if (!moved.contains(mesh.id)) continue;
    move(mesh.tail);
    move(mesh.head);
  }
  for (ShiftElement& coupling : mechanism.couplings) {
    if (!moved.contains(coupling.id)) continue;
    for (LinkId& end : coupling.links) move(end);
  }
  mechanism.links.push_back({part, {}});
  mechanism.turningJoints.push_back(std::move(joint));
  moveWheels(mechanism, link, part, moved);
  if (at) mechanism.view.nodes[part] = *at;
  colors.keepIn(mechanism);
  return mechanism;
}

std::vector<ElementId> lastSideOf(const Mechanism& mechanism, LinkId link) {
  if (mechanism.find(link) == nullptr || link == mechanism.links.front().id) return {};
  const TurningJoint* const carrying = carryingJointOf(mechanism, link);
  if (carrying == nullptr) return {};
  const PositionIndex<LinkTag> links(mechanism.links);
  const LinkId carrier = carrying->tail == link ? carrying->head : carrying->tail;
  DisjointSets groups(mechanism.links.size());
  const auto isOpen = [&](LinkId each) {
    return each != link && each != carrier && each != mechanism.links.front().id;
  };
  const auto position = [&](LinkId each) { return static_cast<std::size_t>(links.positionOf(each)); };
  const auto join = [&](LinkId a, LinkId b) {
    if (isOpen(a) && isOpen(b)) groups.join(position(a), position(b));
  };
  for (const TurningJoint& joint : mechanism.turningJoints) join(joint.tail, joint.head);
  for (const GearMesh& mesh : mechanism.gearMeshes) join(mesh.tail, mesh.head);

  // What is on the link, by the group of its other end; what ends on the carrier or the ground is no side.
  struct Side {
    std::vector<ElementId> elements;
    std::size_t last = 0;  ///< position of the link that was drawn last
  };
  std::map<std::size_t, Side> sides;
  const auto add = [&](const ElementId& element, LinkId a, LinkId b) {
    if (a != link && b != link) return;
    const LinkId end = a == link ? b : a;
    if (isOpen(end)) sides[groups.root(position(end))].elements.push_back(element);
  };
  for (const TurningJoint& joint : mechanism.turningJoints) add(joint.id, joint.tail, joint.head);
  for (const GearMesh& mesh : mechanism.gearMeshes) add(mesh.id, mesh.tail, mesh.head);
  if (sides.size() < 2) return {};
  for (const Link& each : mechanism.links) {
    const auto side = isOpen(each.id) ? sides.find(groups.root(position(each.id))) : sides.end();
    if (side != sides.end()) side->second.last = position(each.id);
  }
  return std::max_element(sides.begin(), sides.end(),
                          [](const auto& a, const auto& b) { return a.second.last < b.second.last; })
      ->second.elements;
}

}  // namespace geargraph
