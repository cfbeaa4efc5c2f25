#include "core/mechanism/model/renumbering.h"

#include <unordered_map>

namespace geargraph {
namespace {

/// The labels of one kind of element: adds those that changed, and tells whether one of `before` is gone.
template <class Element, class LabelBefore, class LabelAfter>
bool addRenumbered(const std::vector<Element>& before, const LabelBefore& labelBefore,
                   const std::vector<Element>& after, const LabelAfter& labelAfter,
                   std::vector<Renumbered>& found) {
  std::unordered_map<std::string_view, int> labels;
  labels.reserve(before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    labels.emplace(before[i].id.text(), labelBefore(static_cast<int>(i)));
  std::size_t kept = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto at = labels.find(after[i].id.text());
    if (at == labels.end()) continue;
    ++kept;
    const int label = labelAfter(static_cast<int>(i));
    if (label != at->second) found.push_back({after[i].id, at->second, label});
  }
  return kept < before.size();
}

}  // namespace

std::vector<Renumbered> renumberedByRemoval(const Mechanism& before, const Mechanism& after) {
  std::vector<Renumbered> found;
  const auto link = [](const Mechanism& m) { return [&m](int place) { return m.linkLabel(place); }; };
  const auto joint = [](const Mechanism& m) { return [&m](int place) { return m.jointLabel(place); }; };
  const auto mesh = [](const Mechanism& m) { return [&m](int place) { return m.meshLabel(place); }; };
  bool isRemoved = addRenumbered(before.links, link(before), after.links, link(after), found);
  isRemoved |= addRenumbered(before.turningJoints, joint(before), after.turningJoints, joint(after), found);
  isRemoved |= addRenumbered(before.gearMeshes, mesh(before), after.gearMeshes, mesh(after), found);
  if (!isRemoved) found.clear();
  return found;
}

}  // namespace geargraph
