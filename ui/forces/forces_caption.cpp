#include "ui/forces/forces_caption.h"

#include "core/presentation/train_stage/forces_caption.h"
#include "ui/models/term_tips.h"

namespace geargraph::inline forces {

QString forcesCaption(const ForcesPtr& forces) {
  const bool isSolved = forces && forces->report && forces->solved;
  static const Mechanism kNone = emptyMechanism();
  return shownText(isSolved
                       ? geargraph::train_stage::forcesCaption(*forces->solved->mechanism, &*forces->report)
                       : geargraph::train_stage::forcesCaption(kNone, nullptr));
}

}  // namespace geargraph::inline forces
