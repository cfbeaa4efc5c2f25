#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "core/theory/analysis/worker.h"

namespace geargraph::inline ui_analysis {

/// The analysis worker for a window: snapshots arrive on the GUI thread, and a stale one never reaches a
/// view.
class AnalysisService : public QObject {
  Q_OBJECT

 public:
  /// `ahead` is called with every snapshot on the thread that made it, before the snapshot sets out for the
  /// GUI thread: further work on it begins while that is busy. Never on two threads at once.
  using Ahead = std::function<void(const SnapshotPtr&)>;
  explicit AnalysisService(
      QObject* parent = nullptr, Ahead ahead = [](const SnapshotPtr&) {});

  /// Does nothing where this revision is what was asked for last: its answer is there or on its way.
  void request(const MechanismPtr& mechanism, quint64 revision);
  /// The newest snapshot that has arrived; null before the first.
  [[nodiscard]] const SnapshotPtr& snapshot() const { return m_snapshot; }
  /// Has the newest request been answered, if only by its live part?
  [[nodiscard]] bool isUpToDate() const { return m_snapshot && m_snapshot->revision == m_wanted; }
  /// Has all of it been answered?
  [[nodiscard]] bool isComplete() const { return isUpToDate() && m_snapshot->isComplete; }

 signals:
  /// Twice a request that is not overtaken: the live part, then the complete snapshot.
  void snapshotReady(const SnapshotPtr& snapshot);

 private:
  void arrived(const SnapshotPtr& snapshot);

  std::optional<quint64> m_wanted;
  SnapshotPtr m_snapshot;
  AnalysisWorker m_worker;  ///< last: it is stopped before what its deliveries touch goes
};

}  // namespace geargraph::inline ui_analysis
