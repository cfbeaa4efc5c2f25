#pragma once

#include "core/machine/teeth/gear_spec.h"

namespace geargraph {

/// What a worm of full thickness, its tips higher by the clearance, leaves of its wheel: the exact envelope
/// in every section square to the wheel's axis. README.md, section 2b. Lengths in the unit of the spec;
/// `height` is that of the section over mid face.
class WormCut {
 public:
  /// A point of the space's flank on the side of growing angles, in a frame whose space at mid face is
  /// centred on +x. The other flank is that of the section at -height, mirrored.
  struct FlankPoint {
    double angle = 0;
    double perRadius = 0;  ///< by how much the angle grows per radius and per height; unused at the root
    double perHeight = 0;
  };

  /// @pre specDiagnostics(wheel) is empty
  explicit WormCut(const GearSpec& wheel);

  /// A circle of the section, with its slope along the axis. The tip circle is lowered where the tooth would
  /// be pointed. The section at -height has the same circles. Cost of the tip: some flank points.
  struct Circle {
    double radius = 0;
    double perHeight = 0;
  };
  [[nodiscard]] Circle root(double height) const;
  [[nodiscard]] Circle tip(double height) const;
  /// Where the throat's arc reaches the cylinder of the rim, over mid face; half the face where it does not.
  [[nodiscard]] double throatEnd() const { return m_throatEnd; }

  /// @pre root(height).radius <= radius. Cost: about 2 microseconds.
  [[nodiscard]] FlankPoint flank(double radius, double height) const;

  /// How much the flank bends along the axis at most, 1 / length.
  [[nodiscard]] double bend() const;

 private:
  /// The edge of the worm's section in the plane at `height`, `depth` from the worm's axis towards the wheel:
  /// its place along the worm, and how that grows.
  struct Edge {
    double along = 0;
    double perDepth = 0;
    double perHeight = 0;
  };
  /// The rounded corner of the cutter's tip, which is raised where it would not cut the rim's edges.
  struct Corner {
    double raise = 0;
    double raisePerHeight = 0;
    double reach = 0;  ///< of the tip, from the worm's axis
  };
  [[nodiscard]] Corner cornerAt(double height) const;
  [[nodiscard]] Edge edgeAt(double depth, double height, const Corner& corner) const;
  [[nodiscard]] Circle blank(double height) const;
  [[nodiscard]] double landAt(double radius, double height) const;

  double m_distance, m_pitch;     ///< between the axes; pitch radius of the wheel
  double m_module, m_pitchAngle;  ///< the angle from tooth to tooth
  double m_wormPitch, m_wormTip;  ///< radii of the cutter
  double m_half, m_slope;         ///< half its thickness at the pitch radius, tangent of its flank's angle
  double m_round, m_roundCentre;  ///< radius of the corner; how far its centre is from the thread's middle
  double m_advance;               ///< of the thread, for 1 rad, positive: right-hand
  double m_throat, m_rim;         ///< radius of the throat's arc about the worm; of the rim's cylinder
  double m_throatEnd;
};

/// The largest radius of the wheel: that of its rim, or of the throat where the face ends in it.
[[nodiscard]] double wormWheelReach(const GearSpec& wheel);

}  // namespace geargraph
