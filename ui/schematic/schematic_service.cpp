#include "ui/schematic/schematic_service.h"

#include "core/mechanism/model/difference.h"

namespace geargraph::inline ui_schematic {

SchematicService::SchematicService(QObject* parent)
    : QObject(parent),
      m_worker([this](const Request& request, const std::stop_token& stop) { draw(request, stop); }) {}

void SchematicService::request(const MechanismPtr& mechanism) {
  const bool same =
      m_mechanism && isSameTrain(*m_mechanism, *mechanism) && m_mechanism->couplings == mechanism->couplings;
  m_mechanism = mechanism;
  if (same) return;
  ++m_wanted;
  m_worker.request({mechanism, m_wanted});
}

void SchematicService::await(std::chrono::milliseconds most) {
  if (isUpToDate()) return;
  Answer answer;
  {
    std::unique_lock lock(m_mutex);
    m_answered.wait_for(lock, most, [this] { return m_answer.number == m_wanted; });
    answer = m_answer;
  }
  if (answer.schematic) arrived(answer.schematic, answer.number);
}

void SchematicService::draw(const Request& request, const std::stop_token& stop) {
  const auto schematic =
      std::make_shared<const SchematicGeometry>(schematicGeometry(*request.mechanism, stop));
  if (stop.stop_requested()) return;
  {
    const std::lock_guard lock(m_mutex);
    m_answer = {schematic, request.number};
  }
  m_answered.notify_one();
  QMetaObject::invokeMethod(
      this, [this, schematic, number = request.number] { arrived(schematic, number); }, Qt::QueuedConnection);
}

void SchematicService::arrived(const SchematicPtr& schematic, quint64 number) {
  if (number != m_wanted || isUpToDate()) return;  // overtaken, or known from await()
  m_arrived = number;
  emit drawn(schematic);
}

}  // namespace geargraph::inline ui_schematic
