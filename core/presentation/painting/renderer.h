#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

#include "core/presentation/painting/camera.h"
#include "core/presentation/painting/image.h"
#include "core/presentation/painting/look.h"
#include "core/presentation/painting/mark_line.h"
#include "core/presentation/painting/scene.h"
#include "core/presentation/painting/seen_map.h"

namespace geargraph::inline painting {

enum class Highlight : std::uint8_t { none, hovered, selected };

/// How much of an instance is to be seen. A ghost is a veil that hides nothing behind it; what is hidden is
/// neither painted nor picked.
enum class Showing : std::uint8_t { solid, ghost, hidden };

/// A plane that cuts the scene open: what lies at normal . x > offset is taken away, and the cut faces of the
/// closed solids are hatched.
struct CutPlane {
  Eigen::Vector3d normal{0, 1, 0};  ///< length 1, world
  double offset = 0;                ///< mm
  friend bool operator==(const CutPlane&, const CutPlane&) = default;
};

/// One picture to be painted. `poses`, `emphasis` and `showing` have one entry an instance of the scene;
/// empty, the scene's own poses hold, no emphasis, and all of it is solid. Nothing but these changes from
/// frame to frame.
struct Frame {
  Viewport viewport;
  double pixelRatio = 1;  ///< device pixels a logical pixel: widths of lines and letters
  Camera camera;
  Look look;
  std::span<const Pose> poses;
  std::span<const Highlight> emphasis;
  std::span<const Showing> showing;
  std::optional<CutPlane> section;
  std::optional<double> floor;      ///< z of the ground's disc; none: just below the scene's own poses
  std::span<const MarkLine> marks;  ///< painted over the solids; faint where a solid is before them
  std::stop_token stop = {};  ///< once requested, painting ends early, and its picture is empty or of no use
  /// Called now and again in a picture that may be stopped, when the driver has nothing left to do.
  std::function<void()> pause = {};
};

/// What lies under a pixel.
struct Hit {
  std::size_t instance = 0;
  ElementId element;
  Eigen::Vector3d point;  ///< where the surface was met, mm in the world; to the depth buffer's precision
};

/// Paints scenes. An interface, so that another way to the graphics card can take the place of OpenGL's.
///
/// All members, the destructor too, need the graphics context that the renderer was made in, current.
class Renderer {
 public:
  virtual ~Renderer() = default;

  /// What paints, as the driver names itself: "llvmpipe (LLVM 15.0.6, 256 bits)".
  [[nodiscard]] virtual const std::string& name() const = 0;
  /// The processor paints: frames are dear, Look::cheaper() is the better default.
  [[nodiscard]] virtual bool isSoftware() const = 0;

  /// Takes up the scene. Solids that the last scene had as well stay where they are.
  virtual void setScene(const Scene& scene) = 0;
  /// Paints into a framebuffer of the context (its number; 0 is the window's own), from its lower left
  /// corner.
  virtual void draw(const Frame& frame, unsigned framebuffer) = 0;
  /// Paints a picture. Its sides are cut to what the driver can hold (maximumSide()).
  [[nodiscard]] virtual Image picture(const Frame& frame) = 0;
  [[nodiscard]] virtual int maximumSide() const = 0;
  /// The nearest instance within one pixel of (x, y), counted from the upper left corner; nothing on the
  /// ground.
  [[nodiscard]] virtual std::optional<Hit> pick(const Frame& frame, double x, double y) = 0;
  /// The whole picture in so many cells; ghosts are seen where nothing else is. Empty where the driver has no
  /// room. Cost: the vertices, and the cells.
  [[nodiscard]] virtual SeenMap seen(const Frame& frame, int columns, int rows) = 0;

 protected:
  Renderer() = default;
  Renderer(const Renderer&) = default;
  Renderer& operator=(const Renderer&) = default;
};

}  // namespace geargraph::inline painting
