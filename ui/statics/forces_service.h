#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "core/presentation/train_stage/train_forces.h"
#include "core/teaching/force_tables/force_table.h"
#include "core/theory/analysis/analysis.h"
#include "ui/service/service.h"

namespace geargraph::inline ui_statics {

/// How torques are solved, beside what the document holds.
struct ForcesQuestion {
  /// Position of the state whose couplings are engaged, instead of those that the document engages; -1:
  /// these.
  int state = -1;
  std::optional<Rational> efficiency;  ///< of meshes that state none
  bool stiffness = false;              ///< shared loads by equal stiffness of all teeth
  friend bool operator==(const ForcesQuestion&, const ForcesQuestion&) = default;
};

/// As analyzeStatics() takes it: with losses, without symbols.
[[nodiscard]] StaticsOptions optionsOf(const ForcesQuestion& question);

struct ForcesRequest {
  SnapshotPtr snapshot;
  ForcesQuestion question;
  bool tables = false;  ///< all tables, the shift table among them, not only what the loads need
};

/// The torques of a snapshot's mechanism, with its tables.
struct Forces {
  SnapshotPtr snapshot;
  /// That of the train as solved: without what the document engages, where the question is about a state.
  SnapshotPtr solved;
  ForcesQuestion question;
  std::optional<StaticsReport> report;  ///< none where the mechanism has errors
  /// On the loads of the document, whatever was asked: as engaged, or in all states where nothing is.
  Diagnostics findings;
  StageForces arrows;              ///< for the 3D view; null where there are none
  std::vector<ForceTable> tables;  ///< allForceTableKinds(), then the shift table where there are states

  /// Null where there is none of the kind.
  [[nodiscard]] const ForceTable* table(ForceTableKind kind) const;
};
using ForcesPtr = std::shared_ptr<const Forces>;

/// Solves the statics of the window's document on a thread of its own, where the document has loads or a view
/// shows torques; else it does nothing, and its answer is null.
class ForcesService final : public Service<ForcesRequest, ForcesPtr> {
 public:
  explicit ForcesService(QObject* parent = nullptr);

  /// The newest analysis: what is solved from now on.
  void follow(const SnapshotPtr& snapshot);
  void ask(const ForcesQuestion& question);
  [[nodiscard]] const ForcesQuestion& question() const { return m_question; }
  /// Does this view show torques now? Then they are solved without loads, too, with all tables.
  void setWatched(const QObject* view, bool watched);

 private:
  void renew();

  SnapshotPtr m_snapshot;
  ForcesQuestion m_question;
  std::set<const QObject*> m_watching;
};

}  // namespace geargraph::inline ui_statics
