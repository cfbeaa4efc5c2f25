#pragma once

#include <memory>

#include "core/presentation/pages/flow.h"
#include "core/theory/analysis/analysis.h"
#include "ui/service/service.h"

namespace geargraph::inline ui_derivation {

using SetReportPtr = std::shared_ptr<const SetReport>;

/// Computes and typesets derivations on a background thread.
///
/// @pre requested snapshots are complete and have at most kMostReportLinks links
class DerivationService final : public Service<SnapshotPtr, SetReportPtr> {
 public:
  explicit DerivationService(QObject* parent = nullptr);
};

}  // namespace geargraph::inline ui_derivation
