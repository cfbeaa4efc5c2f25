#pragma once

#include <string>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/mechanism_scene/scene_picture.h"
#include "core/presentation/mechanism_scene/train_power.h"
#include "core/presentation/scene3d/label_places.h"

namespace geargraph {

/// The overlays of a picture.
struct OverlayChoice {
  bool links = false;
  bool joints = false;
  bool axes = false;
  bool scaleBar = false;
  bool forces = false;  ///< labels and legend of the forces that the view shows
  bool power = false;   ///< arrows along the path of the power, and their legend
  [[nodiscard]] bool any() const { return links || joints || axes || scaleBar || forces || power; }
};

/// The labels and the scale bar of the 3D view as a drawing, for consecutive pictures of an animation: a
/// link's number in a disc ringed with its colour, a joint's in a square, an axis' letter on a plate. Units
/// are logical pixels from the upper left corner; one is ScenePainter::pixelRatio() pixels of the picture.
class SceneLabels {
 public:
  explicit SceneLabels(const OverlayChoice& choice);
  /// Sets the text below the legend of the forces: which are missing and why. Wrapped to the picture's width.
  void setCaption(std::string caption) { m_caption = std::move(caption); }
  /// Shown where the choice wants power; null: there is none, and the caption says why.
  void setPower(ScenePowerPtr power) { m_power = std::move(power); }
  [[nodiscard]] DisplayList over(ScenePainter& painter);

 private:
  OverlayChoice m_choice;
  std::string m_caption;
  ScenePowerPtr m_power;
  LabelPlaces m_places;
};

}  // namespace geargraph
