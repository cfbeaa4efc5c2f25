#include "ui/schematic/schematic_service.h"

#include "core/mechanism/model/difference.h"

namespace geargraph::inline ui_schematic {
namespace {

bool isSameDrawing(const MechanismPtr& before, const MechanismPtr& now) {
  return isSameTrain(*before, *now) && before->couplings == now->couplings;
}

void layOut(const MechanismPtr& mechanism, const SchematicService::Responder& respond) {
  respond(std::make_shared<const SchematicGeometry>(schematicGeometry(*mechanism, respond.stop())));
}

}  // namespace

SchematicService::SchematicService(QObject* parent) : Service(&layOut, parent, {.same = &isSameDrawing}) {}

}  // namespace geargraph::inline ui_schematic
