#include "ui/panels/engagement_edits.h"

#include <QCoreApplication>

#include "core/theory/states/state_edits.h"

namespace geargraph {

Edit releaseAllEdit() {
  return {QCoreApplication::translate("panels", "Release all couplings"),
          [](const Mechanism& before) { return withCouplingsEngaged(before, {}); }, 0};
}

}  // namespace geargraph
