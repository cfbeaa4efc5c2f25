#include "ui/reading/derivation_service.h"

#include <QFont>

namespace geargraph {
namespace {

constexpr double kLeastRoom = 50;  // px

void derive(const DerivationRequest& request, const DerivationService::Responder& respond) {
  Report report = derivationReport(request.snapshot, respond.stop());
  if (respond.stop().stop_requested()) return;
  Derivation derivation{
      std::make_shared<const SetReport>(std::move(report), respond.stop()), request.layout, {}};
  if (respond.stop().stop_requested()) return;
  QFont font;
  font.fromString(request.layout.font);
  derivation.lines = derivationLines(*derivation.report, request.layout, FontMeasure(font));
  respond(std::make_shared<const Derivation>(std::move(derivation)));
}

}  // namespace

std::vector<FlowLine> derivationLines(const SetReport& report, const DerivationLayout& layout,
                                      const FontMeasure& measure) {
  if (layout.width < kLeastRoom) return {};
  FlowParameters flow;
  flow.width = layout.width;
  flow.size = layout.size;
  flow.formulaSize = layout.formulaSize;
  flow.tallest = 1e6;
  flow.leastPart = 0.8;
  flow.leavesOutWide = false;
  return report.lines(flow, measure);
}

DerivationService::DerivationService(QObject* parent) : Service(&derive, parent) {}

}  // namespace geargraph
