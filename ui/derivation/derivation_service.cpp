#include "ui/derivation/derivation_service.h"

namespace geargraph::inline ui_derivation {
namespace {

void derive(const SnapshotPtr& snapshot, const DerivationService::Responder& respond) {
  Report report = derivationReport(snapshot, respond.stop());
  if (respond.stop().stop_requested()) return;
  respond(std::make_shared<const SetReport>(std::move(report), respond.stop()));
}

}  // namespace

DerivationService::DerivationService(QObject* parent) : Service(&derive, parent) {}

}  // namespace geargraph::inline ui_derivation
