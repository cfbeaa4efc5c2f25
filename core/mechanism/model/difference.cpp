#include "core/mechanism/model/difference.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <type_traits>
#include <vector>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/model/fields.h"

namespace geargraph {
namespace {

template <class Element>
Difference::Count countOf(const std::vector<Element>& before, const std::vector<Element>& after) {
  std::map<decltype(Element::id), const Element*> old;
  for (const Element& element : before) old.emplace(element.id, &element);
  Difference::Count count;
  for (const Element& element : after) {
    const auto found = old.find(element.id);
    if (found == old.end()) {
      ++count.added;
      continue;
    }
    if (!(*found->second == element)) ++count.changed;
    old.erase(found);
  }
  count.removed = static_cast<int>(old.size());
  return count;
}

template <class Element>
bool sameOrder(const std::vector<Element>& before, const std::vector<Element>& after) {
  return std::equal(before.begin(), before.end(), after.begin(), after.end(),
                    [](const Element& a, const Element& b) { return a.id == b.id; });
}

bool hasSameMotors(const Mechanism& a, const Mechanism& b) {
  if (!a.inputs || !b.inputs) return !a.inputs && !b.inputs;
  return std::equal(a.inputs->begin(), a.inputs->end(), b.inputs->begin(), b.inputs->end(),
                    [](const Input& x, const Input& y) { return x.joint == y.joint; });
}

/// Does visit(field) hold for every field of the class?
template <class Object, class Visit>
bool allFields(const Visit& visit) {
  return std::apply([&](const auto&... fields) { return (visit(fields) && ...); },
                    Description<Object>::fields);
}

/// Do members differ that Difference has no other word for?
bool hasOtherChanges(const Mechanism& before, const Mechanism& after) {
  const auto isCounted = []<class Member>(const Member& member) {
    using Value = std::remove_cvref_t<decltype(std::declval<Mechanism>().*member)>;
    constexpr bool isCountedList =
        std::is_same_v<Value, ByLink<Link>> || std::is_same_v<Value, ByAxis<Axis>> ||
        std::is_same_v<Value, ByJoint<TurningJoint>> || std::is_same_v<Value, ByMesh<GearMesh>>;
    return isCountedList || std::is_same_v<Value, std::optional<std::vector<Input>>> ||
           std::is_same_v<Value, View>;
  };
  return !allFields<Mechanism>([&](const auto& field) {
    return isCounted(field.member) || before.*field.member == after.*field.member;
  }) || !allFields<View>([&]<class Each>(const Each& field) {
    using Value = typename Each::Value;
    constexpr bool isPlaces =
        std::is_same_v<Value, std::map<LinkId, CanvasPoint>> || std::is_same_v<Value, std::map<LinkId, int>>;
    return isPlaces || before.view.*field.member == after.view.*field.member;
  });
}

/// "2 links, 1 turning joint and 3 gear meshes", or nothing.
std::string countsOf(const Difference& difference, int Difference::Count::*which) {
  std::vector<std::string> parts;
  const auto add = [&](int count, const char* one, const char* many) {
    if (count > 0) parts.push_back(filled(translated(count == 1 ? one : many), {std::to_string(count)}));
  };
  add(difference.links.*which, toTranslate("%1 link"), toTranslate("%1 links"));
  add(difference.joints.*which, toTranslate("%1 turning joint"), toTranslate("%1 turning joints"));
  add(difference.meshes.*which, toTranslate("%1 gear mesh"), toTranslate("%1 gear meshes"));
  return listed(parts, kAllNames);
}

}  // namespace

Difference differenceOf(const Mechanism& before, const Mechanism& after) {
  Difference difference;
  difference.links = countOf(before.links, after.links);
  difference.joints = countOf(before.turningJoints, after.turningJoints);
  difference.meshes = countOf(before.gearMeshes, after.gearMeshes);
  difference.axes = before.axes != after.axes;
  difference.inputs = before.inputs != after.inputs;
  difference.places = before.view.nodes != after.view.nodes || before.view.ttNodes != after.view.ttNodes;
  const bool added = difference.links.added + difference.joints.added + difference.meshes.added > 0;
  const bool removed = difference.links.removed + difference.joints.removed + difference.meshes.removed > 0;
  const bool reordered =
      !added && !removed &&
      !(sameOrder(before.links, after.links) && sameOrder(before.turningJoints, after.turningJoints) &&
        sameOrder(before.gearMeshes, after.gearMeshes));
  // Colours are stored anew where labels move.
  const bool recolored = !added && !removed && !reordered && before.view.colors != after.view.colors;
  difference.other = before.unknown != after.unknown || before.view.unknown != after.view.unknown ||
                     reordered || recolored || hasOtherChanges(before, after);
  return difference;
}

bool isSameButForView(const Mechanism& a, const Mechanism& b) {
  return a.unknown == b.unknown && allFields<Mechanism>([&]<class Each>(const Each& field) {
           return std::is_same_v<typename Each::Value, View> || a.*field.member == b.*field.member;
         });
}

bool isSameTrain(const Mechanism& a, const Mechanism& b) {
  return sameOrder(a.links, b.links) && a.axes == b.axes && a.turningJoints == b.turningJoints &&
         a.gearMeshes == b.gearMeshes && a.wheels == b.wheels && a.gearDefaults == b.gearDefaults &&
         a.inputs == b.inputs && a.engaged == b.engaged && (a.engaged.empty() || a.couplings == b.couplings);
}

bool isSameDigraph(const Mechanism& a, const Mechanism& b) {
  const auto sameEdges = [](const auto& x, const auto& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), [](const auto& one, const auto& other) {
      return one.id == other.id && one.tail == other.tail && one.head == other.head;
    });
  };
  return a.links == b.links && sameEdges(a.turningJoints, b.turningJoints) &&
         sameEdges(a.gearMeshes, b.gearMeshes) && hasSameMotors(a, b) && a.couplings == b.couplings &&
         a.engaged == b.engaged;
}

std::string differenceText(const Difference& difference) {
  std::vector<std::string> clauses;
  const auto clause = [&](int Difference::Count::*which, const char* text) {
    const std::string elements = countsOf(difference, which);
    if (!elements.empty()) clauses.push_back(filled(translated(text), {elements}));
  };
  clause(&Difference::Count::added, toTranslate("%1 added"));
  clause(&Difference::Count::removed, toTranslate("%1 removed"));
  clause(&Difference::Count::changed, toTranslate("%1 changed"));
  // A new joint brings its axis, a new link its place: that goes without saying.
  const bool drawn = difference.links.added + difference.links.removed + difference.joints.added +
                         difference.joints.removed >
                     0;
  if (difference.axes && !drawn) clauses.push_back(translated("axes changed"));
  if (difference.inputs) clauses.push_back(translated("inputs changed"));
  if (difference.places && !drawn) clauses.push_back(translated("links moved in the drawing"));
  if (difference.other) clauses.push_back(translated("other properties changed"));
  if (clauses.empty()) return translated("nothing");
  std::string text = clauses.front();
  for (std::size_t i = 1; i < clauses.size(); ++i) text += "; " + clauses[i];
  return text;
}

}  // namespace geargraph
