#pragma once

#include <QObject>
#include <filesystem>
#include <mutex>

#include "core/foundations/base/request_worker.h"
#include "core/presentation/train_stage/train_stage.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::inline ui_stage {

/// Makes the stages of the 3D view from snapshots, on a thread of its own; the newest request wins, and a
/// stale stage never reaches a view. Solids are kept from one edit to the next. A request that changes
/// nothing of the stage (a node moved, a link renamed) is answered at once with the stage there is.
class StageService : public QObject {
  Q_OBJECT

 public:
  explicit StageService(QObject* parent = nullptr);

  /// The folder of the document, from which the 3D files that links wear are found by the requests to come;
  /// empty: they are left out.
  void setFolder(const std::filesystem::path& folder);
  /// Does the window's own thread paint the stages? Then those to come bring all that painting asks for.
  void setPaintedByWindow(bool isPainted);
  /// From any thread.
  void request(const SnapshotPtr& snapshot);
  [[nodiscard]] const StagePtr& stage() const { return m_stage; }
  /// Has the newest request been answered?
  [[nodiscard]] bool isUpToDate() const { return m_arrived == wanted(); }

 signals:
  void stageReady(const geargraph::StagePtr& stage);

 private:
  struct Request {
    SnapshotPtr snapshot;
    quint64 number = 0;
    std::filesystem::path folder;
    bool isPaintedByWindow = false;
  };

  [[nodiscard]] quint64 wanted() const;
  void make(const Request& request, const std::stop_token& stop);
  void arrived(const StagePtr& stage, quint64 number);

  mutable std::mutex m_mutex;
  quint64 m_wanted = 0;              ///< guarded by m_mutex
  MechanismPtr m_mechanism;          ///< of the newest request; none of another folder; guarded by m_mutex
  std::filesystem::path m_folder;    ///< guarded by m_mutex
  bool m_isPaintedByWindow = false;  ///< guarded by m_mutex
  quint64 m_arrived = 0;
  StagePtr m_stage;
  GearCache m_cache{1024};  ///< of the worker's thread; four details a wheel, and the last edits'
  StageMemory m_memory;
  ShapeCache m_shapes;
  RequestWorker<Request> m_worker;  ///< last: it is stopped before what it uses goes
};

}  // namespace geargraph::inline ui_stage
