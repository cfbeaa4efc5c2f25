#pragma once

#include <cstdint>

#include "core/presentation/scene/scene.h"

namespace geargraph {

/// The face style: shaded faces with edges, visible edges only (as in a drawing), or all edges in the colours
/// of the parts.
enum class Faces : std::uint8_t { shaded, hiddenLine, wireframe };

/// The render style of a scene: background, lines, shadows and antialiasing. The colours of the parts are the
/// scene's own.
struct RenderStyle {
  Rgb groundTop;  ///< of the vertical gradient of the background
  Rgb groundBottom;
  Rgb disc;  ///< of the floor disc
  float discStrength = 0;
  Rgb shadow;  ///< of the contact shadow on it
  float shadowStrength = 0;
  Rgb edge;
  float edgeStrength = 0;
  Rgb accent;                ///< selection
  Rgb letters;               ///< of the axis triad
  bool transparent = false;  ///< no gradient: the background has alpha 0
  Faces faces = Faces::shaded;
  bool edges = true;
  bool contactShadow = true;
  bool triad = true;
  int samples = 4;           ///< per pixel, for antialiasing; 1: none
  bool litByVertex = false;  ///< lighting per vertex (Gouraud) instead of per pixel: nearly the same

  [[nodiscard]] static RenderStyle light();
  [[nodiscard]] static RenderStyle dark();
  /// The same without antialiasing and the contact shadow, which are slow in software rendering.
  [[nodiscard]] RenderStyle cheaper() const;
  friend bool operator==(const RenderStyle&, const RenderStyle&) = default;
};

}  // namespace geargraph
