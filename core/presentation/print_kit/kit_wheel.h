#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/machine/teeth/gear_spec.h"
#include "core/presentation/print_kit/kit_shell.h"

namespace geargraph {

/// A mark that is engraved beside a tooth (dots) or beside the space after a tooth (squares).
struct WheelMark {
  bool isSpace = false;
  int tooth = 0;  ///< from 0; of a space the tooth before it, in the sense of the gear's frame
  int count = 1;  ///< of dots or squares
};

/// What a printed wheel has besides its teeth. Holes are in its print frame, through the whole part, with
/// heights from 0 to 1 that stand for its lower and upper face.
struct WheelRequest {
  GearSpec spec;                             ///< in mm, with the play of the print
  bool isFlipped = false;                    ///< the face of larger z is on the bed
  std::vector<KitOutline> bore;              ///< at most one, counter-clockwise, in the print frame
  std::vector<std::vector<Rim>> holes = {};  ///< clockwise, in mm, in the print frame
  double floor = 0;                          ///< of a ring: its teeth go down to a floor of this thickness
  double below = 0;  ///< and reach as much below the ring's own face, the floor with them
  std::vector<WheelMark> marks = {};
  std::string number = {};
  double chamfer = 0;
};

struct MadeWheel {
  Solid solid;              ///< print frame: its lower face at 0, axis +z
  Eigen::Isometry3d place;  ///< print frame to the gear's frame
  bool hasNumber = false;
  std::vector<bool> hasMark;  ///< by mark of the request: there was room for it
  double overhang = 0;        ///< the flattest downward face of the teeth, rad from the vertical
};

/// The print frame of a wheel: lower face at 0. `below`: as in WheelRequest.
[[nodiscard]] Eigen::Isometry3d printFrameOf(const GearSpec& spec, bool isFlipped, double below = 0);
/// From the lower to the upper face.
[[nodiscard]] double heightOf(const GearSpec& spec);
/// The direction of a tooth (`tooth` may be a half: the space after it) in the plane of one face, about the
/// axis of the print frame.
[[nodiscard]] double toothAngle(const WheelRequest& wheel, double tooth, bool atTop);

/// The wheel as one closed solid: flat on the bed, its first layers smaller by the chamfer, also between the
/// teeth. Marks and number are sunk into the upper face; those of a bevel, whose large end is on the bed,
/// into the lower one. Errors: those of specDiagnostics().
[[nodiscard]] Expected<MadeWheel> printedWheel(const WheelRequest& wheel, double tolerance);

}  // namespace geargraph
