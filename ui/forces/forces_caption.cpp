#include "ui/forces/forces_caption.h"

#include "core/presentation/mechanism_scene/forces_caption.h"
#include "ui/models/term_tips.h"

namespace geargraph {

QString forcesCaption(const ForcesPtr& forces) {
  const bool isSolved = forces && forces->report && forces->solved;
  static const Mechanism kNone = emptyMechanism();
  return shownText(isSolved ? forcesCaption(*forces->solved->mechanism, &*forces->report)
                            : forcesCaption(kNone, nullptr));
}

}  // namespace geargraph
