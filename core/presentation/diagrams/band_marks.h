#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/presentation/diagrams/power_picture.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/obstacle_grid.h"

namespace geargraph {

/// The width of the band with the greatest power, px.
constexpr double kWidestBand = 24;
/// Bands are painted below everything else.
constexpr int kBandDepth = -10;

/// A path in a drawing along which power flows.
struct Band {
  ElementId element;                ///< that is hit there
  std::vector<CanvasPoint> course;  ///< in the direction of the flow
  Tint tint;                        ///< of the link that delivers
  double power = 0;                 ///< W, above 0
  double circulating = 0;           ///< the circulating part of it, W
  bool isKnown = true;              ///< else indeterminate: a dashed line
  bool hasLabel = true;
  bool isAssumed = false;  ///< determined only by the assumption of equal stiffness
};

/// The power lost in a mesh, drawn as a short arrow away from it.
struct LossStub {
  ElementId element;
  CanvasPoint at;
  double power = 0;
};

/// Draws the bands of a picture under a drawing, with labels where these touch nothing: "495.7 W 49.6 %",
/// "495.7 W* 49.6 %" for a power determined only by the assumption of equal stiffness, "? W" for an
/// indeterminate one; above them the scale, the observer, a legend of these marks, and the loops in which
/// power circulates.
class BandPainter {
 public:
  /// `drawing`: labels keep clear of it. Both arguments outlive the painter.
  BandPainter(const PowerPicture& picture, const DisplayList& drawing);

  void add(Band band);
  void add(LossStub stub);
  [[nodiscard]] DisplayList finish() &&;

  /// The width of a band, px; a hairline below a hundredth of the widest.
  [[nodiscard]] double widthOf(double power) const;

 private:
  void drawBand(const Band& band);
  void drawStub(const LossStub& stub);
  bool tryStub(const LossStub& stub, CanvasPoint way, double length);
  void label(const Band& band);
  void drawLegend();
  void put(const ElementId& element, std::variant<Stroke, Fill, Text> what, int z = kBandDepth);
  bool place(const ElementId& element, CanvasPoint at, CanvasPoint way, double gap, const std::string& bold,
             const std::string& plain);

  const PowerPicture& m_picture;
  double m_largest;  ///< W, of all bands: the widest
  Extent m_drawn;
  ObstacleGrid m_taken;
  std::vector<Extent> m_texts;  ///< of the drawing and of the labels so far
  std::vector<Band> m_bands;
  std::vector<LossStub> m_stubs;
  std::set<ElementId> m_marked;  ///< elements with indeterminate power that have a label
  DisplayList m_list;
};

/// "495.7 W", "1.2 kW".
[[nodiscard]] std::string powerText(double power);
/// The chords of a curve.
[[nodiscard]] std::vector<CanvasPoint> courseOf(const Curve& curve);

}  // namespace geargraph
