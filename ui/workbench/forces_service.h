#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "core/presentation/mechanism_scene/train_forces.h"
#include "core/teaching/force_tables/force_table.h"
#include "core/theory/analysis/analysis.h"
#include "ui/service/service.h"

namespace geargraph {

/// The parameters of a statics solution that are not part of the document.
struct ForcesQuestion {
  /// Index of the state whose couplings are engaged; -1: those that the document engages.
  int state = -1;
  std::optional<Rational> efficiency;  ///< of meshes without one of their own
  friend bool operator==(const ForcesQuestion&, const ForcesQuestion&) = default;
};

/// The options for analyzeStatics(): with losses, without symbols.
[[nodiscard]] StaticsOptions optionsOf(const ForcesQuestion& question);

struct ForcesRequest {
  SnapshotPtr snapshot;
  ForcesQuestion question;
  bool tables = false;  ///< all tables, including the shift table, not only those that loads need
};

/// The torques of a snapshot's mechanism, with its tables.
struct Forces {
  SnapshotPtr snapshot;
  /// The snapshot that was solved: without the document's engaged couplings if the question is about a state.
  SnapshotPtr solved;
  ForcesQuestion question;
  std::optional<StaticsReport> report;  ///< std::nullopt if the mechanism has errors
  /// The diagnostics of the document's loads, independent of the question: for the engaged couplings, or for
  /// all states if none is engaged.
  Diagnostics diagnostics;
  SceneForces arrows;              ///< for the 3D view; null if there are none
  std::vector<ForceTable> tables;  ///< all but the shift table, which follows if there are states

  /// Null if there is none of this kind.
  [[nodiscard]] const ForceTable* table(ForceTableKind kind) const;
};
using ForcesPtr = std::shared_ptr<const Forces>;

/// Solves the statics of the window's document on a background thread if the document has loads or a view
/// shows torques; else the answer is null.
class ForcesService final : public Service<ForcesRequest, ForcesPtr> {
 public:
  explicit ForcesService(QObject* parent = nullptr);

  /// Sets the newest analysis, which is solved from now on.
  void follow(const SnapshotPtr& snapshot);
  void ask(const ForcesQuestion& question);
  [[nodiscard]] const ForcesQuestion& question() const { return m_question; }
  /// Tells whether this view shows torques. While any does, statics are solved even without loads, with all
  /// tables.
  void setWatched(const QObject* view, bool watched);

 private:
  void renew();

  SnapshotPtr m_snapshot;
  ForcesQuestion m_question;
  std::set<const QObject*> m_watching;
};

}  // namespace geargraph
