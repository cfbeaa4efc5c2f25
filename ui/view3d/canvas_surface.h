#pragma once

#include <QString>

namespace geargraph {

/// Where the 3D view is rendered: in an OpenGL window, or offscreen to an image.
struct CanvasSurface {
  bool isWindow = true;
  QString why;       ///< of an image: why there is no window; empty if one would be possible
  QString driver{};  ///< OpenGL driver of the window; empty if there is none or it was not queried
};

/// The surface of this program, determined once; the environment variable GEARGRAPH_3D (`window` or `image`)
/// overrides it. @pre a QGuiApplication exists
[[nodiscard]] const CanvasSurface& canvasSurface();

}  // namespace geargraph
