#pragma once

#include <QString>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "core/mechanism/geometry_edits/axis_choice.h"

namespace geargraph {

/// A direction or place for an axis, with its menu text.
struct NamedAxisChoice {
  QString group;  ///< its submenu; empty: none
  QString text;
  AxisChoice choice;
};

/// The largest number of other axes offered as a reference.
constexpr std::size_t kMaxAxesOffered = 30;

/// All choices for these axes: along x, y, z; and relative to each other axis: perpendicular, parallel, or
/// through the point of intersection. Of more than kMaxAxesOffered other axes those separated by the fewest
/// joints are offered.
[[nodiscard]] std::vector<NamedAxisChoice> axisChoices(const Mechanism& mechanism,
                                                       const std::set<AxisId>& of);

/// Fills a menu (QMenu) with the choices; `chosen` is called with the one that the user picks.
template <class Menu>
void fillAxisMenu(Menu& menu, const std::vector<NamedAxisChoice>& choices,
                  const std::function<void(const AxisChoice&)>& chosen) {
  std::map<QString, Menu*> groups;
  for (const NamedAxisChoice& each : choices) {
    Menu* at = &menu;
    if (!each.group.isEmpty()) {
      Menu*& group = groups[each.group];
      if (group == nullptr) group = menu.addMenu(each.group);
      at = group;
    }
    at->addAction(each.text, &menu, [chosen, choice = each.choice] { chosen(choice); });
  }
}

}  // namespace geargraph
