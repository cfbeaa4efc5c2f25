#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

#include "core/presentation/scene/camera.h"
#include "core/presentation/scene/image.h"
#include "core/presentation/scene/mark_line.h"
#include "core/presentation/scene/render_style.h"
#include "core/presentation/scene/scene.h"
#include "core/presentation/scene/seen_map.h"

namespace geargraph {

enum class Highlight : std::uint8_t { none, hovered, selected };

/// The visibility of an instance. A translucent one hides nothing behind it; a hidden instance is
/// neither painted nor picked.
enum class Visibility : std::uint8_t { solid, translucent, hidden };

/// A cutting plane: everything at normal . x > offset is removed, and the cut faces of closed solids are
/// hatched.
struct CutPlane {
  Eigen::Vector3d normal{0, 1, 0};  ///< length 1, world
  double offset = 0;                ///< mm
  friend bool operator==(const CutPlane&, const CutPlane&) = default;
};

/// The description of one picture. `poses`, `emphasis` and `visibility` have one entry per instance of the
/// scene; if empty, the scene's own poses, no highlight and full visibility apply.
struct Frame {
  Viewport viewport;
  double pixelRatio = 1;  ///< device pixels per logical pixel, for widths of lines and letters
  Camera camera;
  RenderStyle style;
  std::span<const Pose> poses;
  std::span<const Highlight> emphasis;
  std::span<const Visibility> visibility;
  std::optional<CutPlane> section;
  std::optional<double> floor;      ///< z of the floor disc; none: just below the scene in its own poses
  std::span<const MarkLine> marks;  ///< painted over the solids; faint where a solid hides them
  std::stop_token stop = {};  ///< once requested, painting ends early; the picture is empty or meaningless
  /// Called occasionally during a picture that can be stopped, while the driver is idle.
  std::function<void()> pause = {};
};

/// What is under a pixel.
struct Hit {
  std::size_t instance = 0;
  ElementId element;
  Eigen::Vector3d point;  ///< on the surface, mm in the world; with the precision of the depth buffer
};

/// Paints scenes. An interface, so that OpenGL can be replaced by another graphics API.
///
/// All members and the destructor need the graphics context in which the renderer was made as the current
/// one.
class Renderer {
 public:
  virtual ~Renderer() = default;

  /// The driver's name: "llvmpipe (LLVM 15.0.6, 256 bits)".
  [[nodiscard]] virtual const std::string& name() const = 0;
  /// Is it software rendering? Then frames are expensive, and RenderStyle::cheaper() is the better default.
  [[nodiscard]] virtual bool isSoftware() const = 0;

  /// Takes up the scene. Solids that the last scene had as well stay where they are.
  virtual void setScene(const Scene& scene) = 0;
  /// Paints into a framebuffer of the context (by number; 0 is the window's), from its lower left corner.
  virtual void draw(const Frame& frame, unsigned framebuffer) = 0;
  /// Paints a picture; its sides are limited to maximumSide().
  [[nodiscard]] virtual Image picture(const Frame& frame) = 0;
  /// The largest side of a picture that the driver supports, px.
  [[nodiscard]] virtual int maximumSide() const = 0;
  /// The nearest instance within one pixel of (x, y), counted from the upper left corner; std::nullopt on the
  /// background.
  [[nodiscard]] virtual std::optional<Hit> pick(const Frame& frame, double x, double y) = 0;
  /// The map of what is visible in a grid of cells over the picture; translucent parts count where nothing
  /// else is. Empty if the driver is out of memory. Cost: the vertices, and the cells.
  [[nodiscard]] virtual VisibilityBuffer seen(const Frame& frame, int columns, int rows) = 0;

 protected:
  Renderer() = default;
  Renderer(const Renderer&) = default;
  Renderer& operator=(const Renderer&) = default;
};

}  // namespace geargraph
