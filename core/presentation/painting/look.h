#pragma once

#include <cstdint>

#include "core/presentation/painting/scene.h"

namespace geargraph::inline painting {

/// What is painted of the solids: lit faces with their edges, edges alone with hidden ones left out (a
/// drawing), or all edges in the colours of the parts.
enum class Faces : std::uint8_t { shaded, hiddenLine, wireframe };

/// How a scene is painted: the ground's colours, which lines and shadows there are, and how finely. The
/// colours of the parts are the scene's own.
struct Look {
  Rgb groundTop;  ///< of the vertical gradient behind everything
  Rgb groundBottom;
  Rgb disc;  ///< of the soft disc that the train stands on
  float discStrength = 0;
  Rgb shadow;  ///< of the contact shadow on it
  float shadowStrength = 0;
  Rgb edge;
  float edgeStrength = 0;
  Rgb accent;                ///< selection
  Rgb letters;               ///< of the axis triad
  bool transparent = false;  ///< no gradient: the ground is left open (alpha 0)
  Faces faces = Faces::shaded;
  bool edges = true;
  bool contactShadow = true;
  bool triad = true;
  int samples = 4;           ///< of antialiasing; 1 is none
  bool litByVertex = false;  ///< the light between the corners of a face is a mean of theirs: nearly the same

  [[nodiscard]] static Look light();
  [[nodiscard]] static Look dark();
  /// The same without what software rendering is slow at: antialiasing and the contact shadow.
  [[nodiscard]] Look cheaper() const;
  friend bool operator==(const Look&, const Look&) = default;
};

}  // namespace geargraph::inline painting
