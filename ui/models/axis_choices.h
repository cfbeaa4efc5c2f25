#pragma once

#include <QString>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "core/mechanism/fitting/axis_choice.h"

namespace geargraph::inline models {

/// A way in which an axis may lie, in the words of a menu.
struct NamedAxisChoice {
  QString group;  ///< the submenu it is in; empty: none
  QString text;
  AxisChoice choice;
};

/// How many axes are offered to lay another one by.
constexpr std::size_t kMostAxesOffered = 30;

/// All ways for these axes: along x, y, z; square to, parallel to, through the meeting point of each other
/// one. Of more than kMostAxesOffered others, those first that the fewest joints are away.
[[nodiscard]] std::vector<NamedAxisChoice> axisChoices(const Mechanism& mechanism,
                                                       const std::set<AxisId>& of);

/// Fills a menu (QMenu) with them.
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

}  // namespace geargraph::inline models
