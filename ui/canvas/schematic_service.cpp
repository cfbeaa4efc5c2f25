#include "ui/canvas/schematic_service.h"

#include "core/mechanism/model/difference.h"

namespace geargraph {
namespace {

bool isSameDrawing(const DerivedGeometryPtr& before, const DerivedGeometryPtr& now) {
  const Mechanism& was = before->mechanism();
  const Mechanism& is = now->mechanism();
  return isSameTrain(was, is) && was.couplings == is.couplings;
}

void layOut(const DerivedGeometryPtr& geometry, const SchematicService::Responder& respond) {
  respond(std::make_shared<const SchematicGeometry>(schematicGeometry(*geometry, respond.stop())));
}

}  // namespace

SchematicService::SchematicService(QObject* parent) : Service(&layOut, parent, {.same = &isSameDrawing}) {}

}  // namespace geargraph
