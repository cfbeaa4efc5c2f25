#include "ui/stage/stage_service.h"

namespace geargraph {
namespace {

/// Do both make the same stage? Names, notes and the places of nodes do not matter.
bool sameStage(const Mechanism& a, const Mechanism& b) {
  const auto ids = [](const Link& x, const Link& y) { return x.id == y.id; };
  return std::equal(a.links.begin(), a.links.end(), b.links.begin(), b.links.end(), ids) &&
         a.axes == b.axes && a.turningJoints == b.turningJoints && a.gearMeshes == b.gearMeshes &&
         a.wheels == b.wheels && a.gearDefaults == b.gearDefaults && a.inputs == b.inputs;
}

}  // namespace

StageService::StageService(QObject* parent)
    : QObject(parent), m_thread([this](const std::stop_token& quit) { run(quit); }) {}

StageService::~StageService() {
  m_thread.request_stop();
  m_thread.join();  // before what its deliveries touch goes
}

void StageService::request(const MechanismPtr& mechanism) {
  const bool same = m_mechanism && sameStage(*m_mechanism, *mechanism);
  m_mechanism = mechanism;
  if (same) return;
  ++m_wanted;
  {
    const std::lock_guard lock(m_mutex);
    m_next = Request{mechanism, m_wanted};
  }
  m_wake.notify_one();
}

void StageService::run(const std::stop_token& quit) {
  GearCache cache;
  while (true) {
    Request request;
    {
      std::unique_lock lock(m_mutex);
      if (!m_wake.wait(lock, quit, [this] { return m_next.has_value(); })) return;
      request = std::move(*m_next);
      m_next.reset();
    }
    StagePtr stage = trainStage(*request.mechanism, cache);
    QMetaObject::invokeMethod(
        this, [this, stage = std::move(stage), number = request.number] { arrived(stage, number); },
        Qt::QueuedConnection);
  }
}

void StageService::arrived(const StagePtr& stage, quint64 number) {
  if (number != m_wanted) return;
  m_arrived = number;
  m_stage = stage;
  emit stageReady(stage);
}

}  // namespace geargraph
