#pragma once

#include <optional>
#include <stop_token>

#include "core/machine/body_layout/arrangement.h"
#include "core/machine/train/train_wheels.h"
#include "core/presentation/schematic/drawn_part.h"

namespace geargraph {
class DerivedGeometry;
}  // namespace geargraph

namespace geargraph {

/// The drawn part of a document's train: placement, wheels and arrangement by the positions of the part. They
/// are those of the whole train, as in the 3D view, without the elements that the part leaves out.
struct DrawnTrain {
  Placement placement;
  TrainWheels wheels;
  Arrangement arrangement;  ///< axes with bearings, arms, shafts, ring-gear carriers, walls, pins and
                            ///< cross-shaft bosses
};

/// The train of the part; if the document's turning joints are no spanning tree, made for the part alone.
/// std::nullopt if the part has no tree, or if cancelled. Cost: DerivedGeometry::arrangement(), and linear in
/// the train.
/// @pre the part is the document's
[[nodiscard]] std::optional<DrawnTrain> drawnTrain(const DrawnPart& part, const DerivedGeometry& document,
                                                   const std::stop_token& stop = {});

}  // namespace geargraph
