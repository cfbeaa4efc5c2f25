#pragma once

#include "core/foundations/base/kind_table.h"
#include "core/machine/teeth/wheel_kind.h"
#include "core/presentation/schematic/sheet_layout.h"

namespace geargraph {

/// How a wheel of the ground stands in the frame.
enum class FrameSymbol {
  hub,    ///< on its hub
  rim,    ///< at its rim
  behind  ///< behind its teeth
};

/// The symbol of a kind of wheel in the section, on the upper side of its axis.
struct WheelSymbol {
  FrameSymbol frame = FrameSymbol::hub;
  /// The height of the pitch line above the pitch radius, in kBarGap: it is beside the partner's.
  int side = -1;
  /// Sets pitch line, place and outward direction of a wheel on axes that are laid out as in space.
  void (*setBar)(SheetWheel& wheel, const TrainWheel& from, const SheetAxis& axis, double scale) = nullptr;
  /// How far the wheel lies from the origin of its frame along its axis, in the document's unit.
  double (*away)(const TrainWheel& from) = nullptr;
};

[[nodiscard]] KindTable<GearKind, WheelSymbol>& wheelSymbols();
[[nodiscard]] const WheelSymbol& wheelSymbol(GearKind kind);

/// The symbols of the kinds that are there; an added kind may use parts of one.
extern const WheelSymbol kDiscSymbol;
extern const WheelSymbol kRingSymbol;
extern const WheelSymbol kConeSymbol;

}  // namespace geargraph
