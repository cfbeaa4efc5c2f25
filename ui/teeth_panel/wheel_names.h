#pragma once

#include <QString>
#include <vector>

#include "core/design/teeth_search/teeth_problem.h"

namespace geargraph {

/// How people know a searched wheel: equal planets by the first of them.
struct WheelName {
  QString
      mark;  ///< "5'", the wheel's name in the document, or "5", its link; of several without names "5·17"
  QString text;  ///< "5' planet", with the name of its link
  QString tip;   ///< "link 5 (planet), meshes with 1 and 2"
  LinkId link;
  int color = 0;  ///< number of its link's colour
  bool isPinned = false;
};

/// By wheel of the problem. Cost: O(wheels · links).
[[nodiscard]] std::vector<WheelName> wheelNames(const TeethProblem& problem);

}  // namespace geargraph
