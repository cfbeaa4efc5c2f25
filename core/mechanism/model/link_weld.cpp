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
#include "core/mechanism/model/joint_forest.h"
#include "core/mechanism/model/link_colors.h"
#include "core/mechanism/model/link_edits.h"
#include "core/mechanism/model/load_edits.h"
#include "core/mechanism/model/rejections.h"
#include "core/mechanism/model/validate.h"

namespace geargraph {
namespace {

using Vector = ExactVector3;

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

// --- axes that links share --------------------------------------------------------------------------------

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
          translated(
              "Links %1 and %2 mesh with each other in mesh %3: delete it before you weld them.",
              {labelOrId(m_before, m_kept), labelOrId(m_before, m_other), labelOrId(m_before, mesh.id)}),
          {mesh.id, m_kept, m_other});
    }
    for (const LinkId link : {m_kept, m_other}) {
      if (!m_before.find(link)->mass) continue;
      return rejection(
          Code::schema,
          translated("The mass of link %1 is stated, and would be that of a part only: remove it "
                     "before you weld the link.",
                     {labelOrId(m_before, link)}),
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
                                  {labelOrId(m_before, goes.id)}),
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
                   {labelOrId(m_before, m_kept), labelOrId(m_before, m_other)}),
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
                                  {labelOrId(m_before, stays.id), labelOrId(m_before, goes.id)}),
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
    Diagnostic why = rejection(
        Code::turningLoop,
        filled(translated(sentence),
               {into.id.text(), from.id.text(), labelOrId(m_before, m_kept), labelOrId(m_before, m_other)}),
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
                     {labelOrId(m_before, m_kept), labelOrId(m_before, m_other), labelOrId(m_before, mesh)}),
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

}  // namespace

Expected<Mechanism> withLinksMerged(Mechanism mechanism, LinkId kept, LinkId other) {
  for (const LinkId link : {kept, other}) {
    if (mechanism.find(link) == nullptr) return unknownElement(link);
  }
  if (kept == other)
    return rejection(Code::selfJoint, translated("A weld needs two different links."), {kept});
  if (other == mechanism.links.front().id) std::swap(kept, other);
  return Weld(std::move(mechanism), kept, other).run();
}

}  // namespace geargraph
