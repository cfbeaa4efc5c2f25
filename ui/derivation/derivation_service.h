#pragma once

#include <memory>

#include "core/presentation/pages/flow.h"
#include "core/theory/analysis/analysis.h"
#include "ui/service/service.h"

namespace geargraph::inline ui_derivation {

using SetReportPtr = std::shared_ptr<const SetReport>;

/// Works out and sets derivations.
///
/// @pre the snapshots that are requested are complete and of no more than kMostReportLinks links
class DerivationService final : public Service<SnapshotPtr, SetReportPtr> {
 public:
  explicit DerivationService(QObject* parent = nullptr);
};

}  // namespace geargraph::inline ui_derivation
