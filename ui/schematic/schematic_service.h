#pragma once

#include <QObject>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>

#include "core/foundations/base/request_worker.h"
#include "core/presentation/schematic/schematic.h"

namespace geargraph::inline ui_schematic {

using SchematicPtr = std::shared_ptr<const SchematicGeometry>;

/// Lays schematics out on a thread of its own; the newest request wins, and a stale drawing never reaches the
/// view. A request that changes nothing of the drawing (a node moved, a link renamed) is answered already.
class SchematicService : public QObject {
  Q_OBJECT

 public:
  explicit SchematicService(QObject* parent = nullptr);

  void request(const MechanismPtr& mechanism);
  /// Waits for the answer to the newest request, if it comes soon enough: drawn() is then told at once.
  void await(std::chrono::milliseconds most);
  /// Has the newest request been answered?
  [[nodiscard]] bool isUpToDate() const { return m_arrived == m_wanted; }

 signals:
  void drawn(const geargraph::SchematicPtr& schematic);

 private:
  struct Request {
    MechanismPtr mechanism;
    quint64 number = 0;
  };

  void draw(const Request& request, const std::stop_token& stop);
  void arrived(const SchematicPtr& schematic, quint64 number);

  quint64 m_wanted = 0;
  quint64 m_arrived = 0;
  MechanismPtr m_mechanism;  ///< of the newest request
  struct Answer {
    SchematicPtr schematic;
    quint64 number = 0;
  };
  std::mutex m_mutex;
  std::condition_variable m_answered;
  Answer m_answer;                  ///< the last one; guarded by m_mutex
  RequestWorker<Request> m_worker;  ///< last: it is stopped before what it uses goes
};

}  // namespace geargraph::inline ui_schematic
