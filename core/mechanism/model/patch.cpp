#include "core/mechanism/model/patch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <type_traits>
#include <unordered_set>

#include "core/foundations/base/contract.h"
#include "core/mechanism/model/patch_bytes.h"

namespace geargraph::inline model {
namespace {

// --- texts ------------------------------------------------------------------------------------------------

std::optional<TextPatch> textPatch(const std::string& before, const std::string& after) {
  if (before == after) return std::nullopt;
  const std::size_t shorter = std::min(before.size(), after.size());
  const auto first =
      std::mismatch(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(shorter), after.begin());
  const auto at = static_cast<std::size_t>(first.first - before.begin());
  std::size_t end = 0;
  while (end < shorter - at && before[before.size() - 1 - end] == after[after.size() - 1 - end]) ++end;
  return TextPatch{at, before.substr(at, before.size() - at - end),
                   after.substr(at, after.size() - at - end)};
}

void apply(const std::optional<TextPatch>& patch, std::string& text, bool forward) {
  if (!patch) return;
  const std::string& from = forward ? patch->before : patch->after;
  text.replace(patch->at, from.size(), forward ? patch->after : patch->before);
}

// --- lists ------------------------------------------------------------------------------------------------

Atom keyOf(const Input& input) {
  return input.joint.atom();
}
const std::string& keyOf(const ShiftState& state) {
  return state.name;
}
template <class Element>
Atom keyOf(const Element& element) {
  return element.id.atom();
}

/// Finds the runs in which two lists differ: elements are matched by their keys, and from where the order of
/// the keys differs, the rest is one run.
template <class Element>
class ListComparison {
 public:
  ListComparison(const std::vector<Element>& before, const std::vector<Element>& after)
      : m_before(before), m_after(after) {}

  ListPatch<Element> run() {
    const std::size_t shorter = std::min(m_before.size(), m_after.size());
    while (m_b < shorter && m_before[m_b] == m_after[m_b]) ++m_b;
    m_a = m_b;
    while (m_end < shorter - m_b &&
           m_before[m_before.size() - 1 - m_end] == m_after[m_after.size() - 1 - m_end]) {
      ++m_end;
    }
    compareMiddle();
    return std::move(m_patch);
  }

 private:
  using Key = std::decay_t<decltype(keyOf(std::declval<const Element&>()))>;

  [[nodiscard]] std::size_t beforeEnd() const { return m_before.size() - m_end; }
  [[nodiscard]] std::size_t afterEnd() const { return m_after.size() - m_end; }

  void compareMiddle() {
    std::unordered_set<Key> olds, news;
    for (std::size_t i = m_b; i < beforeEnd(); ++i) olds.insert(keyOf(m_before[i]));
    for (std::size_t i = m_a; i < afterEnd(); ++i) news.insert(keyOf(m_after[i]));
    while (m_b < beforeEnd() && m_a < afterEnd()) {
      const Element& old = m_before[m_b];
      const Element& now = m_after[m_a];
      if (keyOf(old) == keyOf(now)) {
        if (old == now) {
          ++m_b, ++m_a;
        } else {
          take(1, 1);
        }
      } else if (!news.contains(keyOf(old))) {
        take(1, 0);
      } else if (!olds.contains(keyOf(now))) {
        take(0, 1);
      } else {
        break;
      }
    }
    take(beforeEnd() - m_b, afterEnd() - m_a);
  }

  /// The next elements of both lists differ.
  void take(std::size_t olds, std::size_t news) {
    if (olds + news == 0) return;
    const bool goesOn = !m_patch.empty() && m_patch.back().beforeAt + m_patch.back().before.size() == m_b &&
                        m_patch.back().afterAt + m_patch.back().after.size() == m_a;
    if (!goesOn) m_patch.push_back({m_b, m_a, {}, {}});
    for (; olds > 0; --olds) m_patch.back().before.push_back(m_before[m_b++]);
    for (; news > 0; --news) m_patch.back().after.push_back(m_after[m_a++]);
  }

  const std::vector<Element>& m_before;
  const std::vector<Element>& m_after;
  std::size_t m_b = 0;
  std::size_t m_a = 0;
  std::size_t m_end = 0;  ///< equal elements at the ends
  ListPatch<Element> m_patch;
};

template <class Element>
ListPatch<Element> listPatch(const std::vector<Element>& before, const std::vector<Element>& after) {
  return ListComparison(before, after).run();
}

template <class Element>
void apply(const ListPatch<Element>& patch, std::vector<Element>& list, bool forward) {
  if (patch.empty()) return;
  std::vector<Element> next;
  std::size_t taken = 0;
  const auto takeTo = [&](std::size_t end) {
    GEARGRAPH_REQUIRE(taken <= end && end <= list.size());
    for (; taken < end; ++taken) next.push_back(std::move(list[taken]));
  };
  for (const ListRun<Element>& run : patch) {
    const std::vector<Element>& gone = forward ? run.before : run.after;
    const std::vector<Element>& come = forward ? run.after : run.before;
    takeTo(forward ? run.beforeAt : run.afterAt);
    next.insert(next.end(), come.begin(), come.end());
    taken += gone.size();
  }
  takeTo(list.size());
  list = std::move(next);
}

// --- members and nodes ------------------------------------------------------------------------------------

template <class Value>
ValuePatch<Value> valuePatch(const Value& before, const Value& after) {
  return before == after ? std::nullopt : ValuePatch<Value>({before, after});
}

template <class Value>
void apply(const ValuePatch<Value>& patch, Value& value, bool forward) {
  if (patch) value = forward ? patch->second : patch->first;
}

MemberPatch memberPatch(const UnknownMembers& before, const UnknownMembers& after) {
  MemberPatch patch;
  const bool sameNames = std::equal(before.begin(), before.end(), after.begin(), after.end(),
                                    [](const auto& old, const auto& now) { return old.first == now.first; });
  if (!sameNames) {
    patch.replaced = {before, after};
    return patch;
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (auto text = textPatch(before[i].second, after[i].second)) patch.changed.emplace_back(i, *text);
  }
  return patch;
}

void apply(const MemberPatch& patch, UnknownMembers& members, bool forward) {
  apply(patch.replaced, members, forward);
  for (const auto& [position, text] : patch.changed) apply(text, members[position].second, forward);
}

template <class Value>
bool isNothing(const std::optional<Value>& patch) {
  return !patch;
}
template <class Element>
bool isNothing(const std::vector<Element>& patch) {
  return patch.empty();
}
bool isNothing(const MemberPatch& patch) {
  return patch.changed.empty() && !patch.replaced;
}

const std::vector<Input> kNoInputs;

const std::vector<Input>& inputsOf(const Mechanism& mechanism) {
  return mechanism.inputs ? *mechanism.inputs : kNoInputs;
}

/// By their bits: a coordinate of -0 is written otherwise than one of 0.
ValuePatch<std::optional<ViewCamera>> cameraPatch(const std::optional<ViewCamera>& before,
                                                  const std::optional<ViewCamera>& after) {
  const auto bits = [](const ViewCamera& camera) {
    std::array<std::uint64_t, 6> all{};
    for (std::size_t i = 0; i < 3; ++i) all[i] = std::bit_cast<std::uint64_t>(camera.target[i]);
    all[3] = std::bit_cast<std::uint64_t>(camera.azimuth);
    all[4] = std::bit_cast<std::uint64_t>(camera.elevation);
    all[5] = std::bit_cast<std::uint64_t>(camera.distance);
    return all;
  };
  if (before == after && (!before || bits(*before) == bits(*after))) return std::nullopt;
  return {{before, after}};
}

}  // namespace

MechanismPatch::MechanismPatch(const Mechanism& before, const Mechanism& after)
    : m_name(textPatch(before.name, after.name)),
      m_notes(textPatch(before.notes, after.notes)),
      m_unit(textPatch(before.unit, after.unit)),
      m_links(listPatch(before.links, after.links)),
      m_axes(listPatch(before.axes, after.axes)),
      m_turningJoints(listPatch(before.turningJoints, after.turningJoints)),
      m_gearMeshes(listPatch(before.gearMeshes, after.gearMeshes)),
      m_wheels(listPatch(before.wheels, after.wheels)),
      m_couplings(listPatch(before.couplings, after.couplings)),
      m_inputs(listPatch(inputsOf(before), inputsOf(after))),
      m_states(listPatch(before.states, after.states)),
      m_engaged(valuePatch(before.engaged, after.engaged)),
      m_loads(listPatch(before.loads, after.loads)),
      m_inputsBefore(before.inputs.has_value()),
      m_inputsAfter(after.inputs.has_value()),
      m_gearDefaults(valuePatch(before.gearDefaults, after.gearDefaults)),
      m_balances(valuePatch(before.balances, after.balances)),
      m_sharing(valuePatch(before.sharing, after.sharing)),
      m_driveTorque(valuePatch(before.driveTorque, after.driveTorque)),
      m_density(valuePatch(before.density, after.density)),
      m_gravity(valuePatch(before.gravity, after.gravity)),
      m_nodes(nodePatch(before.view.nodes, after.view.nodes)),
      m_ttNodes(nodePatch(before.view.ttNodes, after.view.ttNodes)),
      m_sheetNotes(listPatch(before.view.notes, after.view.notes)),
      m_camera(cameraPatch(before.view.camera, after.view.camera)),
      m_viewMembers(memberPatch(before.view.unknown, after.view.unknown)),
      m_members(memberPatch(before.unknown, after.unknown)) {
  const std::map<LinkId, int>& olds = before.view.colors;
  const std::map<LinkId, int>& news = after.view.colors;
  std::set_difference(olds.begin(), olds.end(), news.begin(), news.end(), std::back_inserter(m_colorsBefore));
  std::set_difference(news.begin(), news.end(), olds.begin(), olds.end(), std::back_inserter(m_colorsAfter));
  m_isEmpty = hasNothing();
  count();
}

MechanismPatch::NodePatch MechanismPatch::nodePatch(const std::map<LinkId, SheetPoint>& before,
                                                    const std::map<LinkId, SheetPoint>& after) {
  // By their bits: a place of -0 is written otherwise than one of 0.
  const auto byId = [](const auto& a, const auto& b) {
    const auto bits = [](const auto& node) {
      return std::pair(std::bit_cast<std::uint64_t>(node.second.x),
                       std::bit_cast<std::uint64_t>(node.second.y));
    };
    return a.first != b.first ? a.first < b.first : bits(a) < bits(b);
  };
  NodePatch patch;
  std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
                      std::back_inserter(patch.before), byId);
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                      std::back_inserter(patch.after), byId);
  return patch;
}

void MechanismPatch::apply(const NodePatch& patch, std::map<LinkId, SheetPoint>& nodes, bool forward) {
  for (const Node& node : forward ? patch.before : patch.after) nodes.erase(node.first);
  const std::vector<Node>& come = forward ? patch.after : patch.before;
  nodes.insert(come.begin(), come.end());
}

Mechanism MechanismPatch::forward(Mechanism before) const {
  apply(before, true);
  return before;
}

Mechanism MechanismPatch::back(Mechanism after) const {
  apply(after, false);
  return after;
}

void MechanismPatch::apply(Mechanism& mechanism, bool forward) const {
  geargraph::apply(m_name, mechanism.name, forward);
  geargraph::apply(m_notes, mechanism.notes, forward);
  geargraph::apply(m_unit, mechanism.unit, forward);
  geargraph::apply(m_links, mechanism.links, forward);
  geargraph::apply(m_axes, mechanism.axes, forward);
  geargraph::apply(m_turningJoints, mechanism.turningJoints, forward);
  geargraph::apply(m_gearMeshes, mechanism.gearMeshes, forward);
  geargraph::apply(m_wheels, mechanism.wheels, forward);
  geargraph::apply(m_couplings, mechanism.couplings, forward);
  geargraph::apply(m_states, mechanism.states, forward);
  geargraph::apply(m_engaged, mechanism.engaged, forward);
  geargraph::apply(m_loads, mechanism.loads, forward);
  std::vector<Input> inputs = inputsOf(mechanism);
  geargraph::apply(m_inputs, inputs, forward);
  mechanism.inputs.reset();
  if (forward ? m_inputsAfter : m_inputsBefore) mechanism.inputs = std::move(inputs);
  geargraph::apply(m_gearDefaults, mechanism.gearDefaults, forward);
  geargraph::apply(m_balances, mechanism.balances, forward);
  geargraph::apply(m_sharing, mechanism.sharing, forward);
  geargraph::apply(m_driveTorque, mechanism.driveTorque, forward);
  geargraph::apply(m_density, mechanism.density, forward);
  geargraph::apply(m_gravity, mechanism.gravity, forward);
  apply(m_nodes, mechanism.view.nodes, forward);
  apply(m_ttNodes, mechanism.view.ttNodes, forward);
  geargraph::apply(m_sheetNotes, mechanism.view.notes, forward);
  geargraph::apply(m_camera, mechanism.view.camera, forward);
  for (const LinkColor& color : forward ? m_colorsBefore : m_colorsAfter)
    mechanism.view.colors.erase(color.first);
  const std::vector<LinkColor>& colors = forward ? m_colorsAfter : m_colorsBefore;
  mechanism.view.colors.insert(colors.begin(), colors.end());
  geargraph::apply(m_viewMembers, mechanism.view.unknown, forward);
  geargraph::apply(m_members, mechanism.unknown, forward);
}

bool MechanismPatch::hasNothing() const {
  const auto areNothing = [](const auto&... patches) { return (isNothing(patches) && ...); };
  return m_inputsBefore == m_inputsAfter &&
         areNothing(m_name, m_notes, m_unit, m_links, m_axes, m_turningJoints, m_gearMeshes, m_wheels,
                    m_couplings, m_inputs, m_states, m_engaged, m_loads, m_gearDefaults, m_balances,
                    m_sharing, m_driveTorque, m_density, m_gravity, m_nodes.before, m_nodes.after,
                    m_ttNodes.before, m_ttNodes.after, m_sheetNotes, m_camera, m_colorsBefore, m_colorsAfter,
                    m_viewMembers, m_members);
}

void MechanismPatch::count() {
  ByteCount bytes;
  bytes.add(m_name, m_notes, m_unit, m_links, m_axes, m_turningJoints, m_gearMeshes, m_wheels, m_couplings,
            m_inputs, m_states, m_engaged, m_loads, m_gearDefaults, m_balances, m_sharing, m_driveTorque,
            m_density, m_gravity, m_nodes.before, m_nodes.after, m_ttNodes.before, m_ttNodes.after,
            m_sheetNotes, m_camera, m_colorsBefore, m_colorsAfter, m_viewMembers, m_members);
  m_bytes = sizeof(MechanismPatch) + bytes.total();
}

}  // namespace geargraph::inline model
