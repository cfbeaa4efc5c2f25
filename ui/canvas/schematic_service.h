#pragma once

#include <memory>

#include "core/machine/body_layout/derived_geometry.h"
#include "core/presentation/schematic/schematic.h"
#include "ui/service/service.h"

namespace geargraph {

using SchematicPtr = std::shared_ptr<const SchematicGeometry>;

/// Lays out schematics on a background thread. A request that does not change the drawing (a node moved, a
/// link renamed) is not computed again.
class SchematicService final : public Service<DerivedGeometryPtr, SchematicPtr> {
 public:
  explicit SchematicService(QObject* parent = nullptr);
};

}  // namespace geargraph
