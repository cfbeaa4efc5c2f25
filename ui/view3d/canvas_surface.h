#pragma once

#include <QString>

namespace geargraph::inline view3d {

/// Where the picture is painted: in a window of the graphics card, or beside the screen.
struct CanvasSurface {
  bool isWindow = true;
  QString why;       ///< of an image: empty where a window would be possible as well
  QString driver{};  ///< of the window's OpenGL; empty if there is none or it was not asked
};

/// What this program paints on, decided once; the GEARGRAPH_3D of the environment overrides it: `window` or
/// `image`. @pre there is an application
[[nodiscard]] const CanvasSurface& canvasSurface();

}  // namespace geargraph::inline view3d
