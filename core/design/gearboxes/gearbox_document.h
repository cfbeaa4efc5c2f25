#pragma once

#include <optional>
#include <stop_token>

#include "core/design/gearboxes/gearbox.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The gearbox as a document: links in the order of the layout's numbers, one planet or pair of each set in
/// its place, module 2 mm, brakes and clutches A, B, ..., a state for each gear; the first gear is engaged
/// and its input turns at 1 rad/s. Meshes have the basic efficiencies of the wish.
/// @pre the gearbox is one of judged() for this wish
[[nodiscard]] Mechanism gearboxDocument(const GearboxWish& wish, const Gearbox& gearbox);

/// What checking a gearbox by its document found.
enum class GearboxCheck : std::uint8_t {
  right,
  wrong,    ///< a state of the document has another ratio
  limited,  ///< an efficiency or circulating power exceeds a limit of the wish
  stopped   ///< `stop` was requested
};

/// Solves the states of the document and compares their ratios with the gearbox's, in fractions; then, with
/// `statics` or where the wish limits them, adds the losses and circulating power of each gear under a torque
/// at its input. Cost: some eliminations of the document for each state.
[[nodiscard]] GearboxCheck checkByDocument(const GearboxWish& wish, Gearbox& gearbox, bool statics,
                                           const std::stop_token& stop = {});

}  // namespace geargraph
