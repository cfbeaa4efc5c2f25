#include "ui/designer/hub_services.h"

#include "core/presentation/schematic/schematic.h"

namespace geargraph {
namespace {

void searchHubs(const HubWishPtr& wish, const HubService::Responder& respond) {
  auto search = findHubs(*wish, respond.stop());
  if (search) respond(std::make_shared<const HubSearch>(*std::move(search)));
}

void drawHub(const HubCandidate& candidate, const HubDetailService::Responder& respond) {
  auto document = std::make_shared<const Mechanism>(hubDocument(candidate));
  DisplayList schematic = schematicDrawing(schematicGeometry(*document, respond.stop()), {});
  respond(std::make_shared<const HubDetail>(HubDetail{candidate, std::move(document), std::move(schematic)}));
}

}  // namespace

HubService::HubService(QObject* parent) : Service(&searchHubs, parent) {}

HubDetailService::HubDetailService(QObject* parent) : Service(&drawHub, parent) {}

}  // namespace geargraph
