#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/teaching/force_tables/force_table.h"
#include "core/theory/analysis/analysis.h"
#include "ui/service/service.h"

namespace geargraph::inline forces {

/// What is asked about the torques of a document.
struct ForcesRequest {
  SnapshotPtr snapshot;
  /// Position of the state whose couplings are engaged, instead of those that the document engages; -1:
  /// these.
  int state = -1;
  std::optional<Rational> efficiency;  ///< of meshes that state none
  bool stiffness = false;              ///< shared loads by equal stiffness of all teeth
};

/// The torques of a snapshot's mechanism, with its tables.
struct Forces {
  SnapshotPtr snapshot;
  int state = -1;
  std::optional<StaticsReport> report;  ///< none where the mechanism has errors
  std::vector<ForceTable> tables;       ///< allForceTableKinds(), then the shift table where there are states

  /// Null where there is none of the kind.
  [[nodiscard]] const ForceTable* table(ForceTableKind kind) const;
};
using ForcesPtr = std::shared_ptr<const Forces>;

/// Solves the statics of the window's document on a thread of its own.
class ForcesService final : public Service<ForcesRequest, ForcesPtr> {
 public:
  explicit ForcesService(QObject* parent = nullptr);
};

}  // namespace geargraph::inline forces
