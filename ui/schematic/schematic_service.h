#pragma once

#include <QObject>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/schematic/schematic.h"

namespace geargraph {

using SchematicPtr = std::shared_ptr<const SchematicGeometry>;

/// Lays schematics out on a thread of its own; the newest request wins, and a stale drawing never reaches the
/// view. A request that changes nothing of the drawing (a node moved, a link renamed) is answered already.
class SchematicService : public QObject {
  Q_OBJECT

 public:
  explicit SchematicService(QObject* parent = nullptr);
  ~SchematicService() override;

  void request(const MechanismPtr& mechanism);
  /// Has the newest request been answered?
  [[nodiscard]] bool isUpToDate() const { return m_arrived == m_wanted; }

 signals:
  void drawn(const geargraph::SchematicPtr& schematic);

 private:
  struct Request {
    MechanismPtr mechanism;
    quint64 number = 0;
  };

  void run(const std::stop_token& quit);
  void arrived(const SchematicPtr& schematic, quint64 number);

  quint64 m_wanted = 0;
  quint64 m_arrived = 0;
  MechanismPtr m_mechanism;  ///< of the newest request
  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::optional<Request> m_next;  ///< guarded by m_mutex
  std::jthread m_thread;          ///< last: it starts when all else is there
};

}  // namespace geargraph
