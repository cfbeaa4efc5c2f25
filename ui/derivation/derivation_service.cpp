#include "ui/derivation/derivation_service.h"

namespace geargraph::inline ui_derivation {

DerivationService::DerivationService(QObject* parent)
    : QObject(parent),
      m_worker([this](const Request& request, const std::stop_token& stop) { make(request, stop); }) {}

void DerivationService::request(const SnapshotPtr& snapshot) {
  m_worker.request({snapshot, ++m_wanted});
}

void DerivationService::make(const Request& request, const std::stop_token& stop) {
  Report report = derivationReport(request.snapshot, stop);
  if (stop.stop_requested()) return;
  const auto set = std::make_shared<const SetReport>(std::move(report), stop);
  if (stop.stop_requested()) return;
  QMetaObject::invokeMethod(
      this,
      [this, set, number = request.number] {
        if (number == m_wanted) emit ready(set);
      },
      Qt::QueuedConnection);
}

}  // namespace geargraph::inline ui_derivation
