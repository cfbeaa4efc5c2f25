#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "core/presentation/page_layout/flow.h"
#include "core/theory/analysis/analysis.h"
#include "ui/reading/flow_painter.h"
#include "ui/service/service.h"

namespace geargraph {

using SetReportPtr = std::shared_ptr<const SetReport>;

/// What the lines of a view depend on, beside the report.
struct DerivationLayout {
  double width = 0;        ///< px
  double size = 0;         ///< px, of the em of words
  double formulaSize = 0;  ///< px, of the em of formulas
  QString font;            ///< QFont::toString(): a QFont and its copies are for one thread
  friend bool operator==(const DerivationLayout&, const DerivationLayout&) = default;
};

/// The lines of a report; none where there is no room. Cost: linear in the report.
/// @param measure  that of the layout's font
[[nodiscard]] std::vector<FlowLine> derivationLines(const SetReport& report, const DerivationLayout& layout,
                                                    const FontMeasure& measure);

struct DerivationRequest {
  SnapshotPtr snapshot;
  DerivationLayout layout;
};

/// A typeset derivation, and its lines in the layout that was requested.
struct Derivation {
  SetReportPtr report;
  DerivationLayout layout;
  std::vector<FlowLine> lines;
};

using DerivationPtr = std::shared_ptr<const Derivation>;

/// Computes, typesets and lays out derivations on a background thread.
///
/// @pre requested snapshots are complete and have at most kMaxReportLinks links
class DerivationService final : public Service<DerivationRequest, DerivationPtr> {
 public:
  explicit DerivationService(QObject* parent = nullptr);
};

}  // namespace geargraph
