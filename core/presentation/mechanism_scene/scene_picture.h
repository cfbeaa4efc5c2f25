#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "core/foundations/base/expected.h"
#include "core/presentation/drawing/palette.h"
#include "core/presentation/gl_renderer/egl_host.h"
#include "core/presentation/meshfile/mesh_scene.h"
#include "core/presentation/scene3d/animation.h"
#include "core/presentation/scene3d/label_anchors.h"
#include "core/presentation/scene3d/scene_view.h"

namespace geargraph {

/// Sides of a picture in pixels.
constexpr int kLeastPictureSide = 16;
constexpr int kMaxPictureSide = 8192;

/// The theme's render style for files: with more samples; `transparent`: without background and floor disc,
/// only the shadow shows the floor.
[[nodiscard]] RenderStyle pictureStyle(Theme theme, bool transparent);

/// A picture or animation of a stage, as it is to be rendered.
struct SceneRendering {
  MechanismScenePtr stage;
  SceneView view;
  Viewport size{1600, 1000};
  bool fits = true;  ///< the camera keeps its direction and moves so that all pictures show everything
  std::optional<Animation> animation;
  double pixelRatio = 0;  ///< pixels per logical pixel, for the widths of lines; 0: from the height
};

/// Paints the pictures of a rendering offscreen. To be used on the thread that made it.
class ScenePainter {
 public:
  /// Fails with `graphics` if no renderer is available, or the picture is too large for the driver. Null if
  /// `stop` was requested meanwhile; a later request ends the current picture, which is then empty. Cost: a
  /// context and shaders; for a rendering that fits, the outline of each solid and up to 24 poses of an
  /// animation.
  [[nodiscard]] static Expected<std::unique_ptr<ScenePainter>> create(SceneRendering rendering,
                                                                      const std::stop_token& stop = {});

  /// The number of pictures; 1 without an animation.
  [[nodiscard]] int pictures() const { return m_rendering.animation ? m_rendering.animation->frames : 1; }
  /// Empty if the driver is out of memory, or `stop` was requested.
  [[nodiscard]] Image paint(int picture);
  /// The VisibilityBuffer of the last picture, and the data for label placement with it, which refers to the
  /// painter and the map. The map is meaningless once stopped. @pre paint() was called
  [[nodiscard]] VisibilityBuffer seenForLabels();
  [[nodiscard]] LabelGround labelGround(const VisibilityBuffer& seen) const;
  /// The prepared view of the last picture.
  [[nodiscard]] const SeenStage& seen() const { return m_seen; }
  [[nodiscard]] const SceneView& view() const { return m_now; }
  [[nodiscard]] double pixelRatio() const;
  [[nodiscard]] const SceneRendering& rendering() const { return m_rendering; }

 private:
  ScenePainter(SceneRendering rendering, std::stop_token stop, std::unique_ptr<EglHost> host);
  void fit();
  void fitAnimation();
  [[nodiscard]] SceneView viewOf(int picture) const;
  [[nodiscard]] Frame frame() const;

  SceneRendering m_rendering;
  std::stop_token m_stop;
  std::unique_ptr<EglHost> m_host;
  SeenStage m_seen;
  SceneView m_now;
};

/// One picture of the rendering, ignoring its animation.
[[nodiscard]] Expected<Image> stagePicture(SceneRendering rendering);

/// Why a rendering was not written.
struct RenderingFailure {
  enum class Kind { stopped, graphics, file };
  Kind kind = Kind::file;
  std::string message;
};

struct RenderingRun {
  std::function<void(int done, int all)> progress;    ///< after each picture, on the caller's thread
  std::stop_token stop;                               ///< also ends the current picture
  std::function<void(Image&, ScenePainter&)> finish;  ///< paints over each picture, for example labels;
                                                      ///< empties the image on failure
  bool mayOverwrite = false;                          ///< files in an existing folder
};

/// Writes the rendering as one file, atomically: a PNG, animated if the rendering has an animation. "-" is
/// standard output.
[[nodiscard]] std::optional<RenderingFailure> writePicture(const SceneRendering& rendering,
                                                           const std::filesystem::path& path,
                                                           const RenderingRun& run = {});

/// Writes the animation as PNGs in a folder, "0001.png" and so on; they appear in the folder when all are
/// painted, or not at all.
[[nodiscard]] std::optional<RenderingFailure> writePictures(const SceneRendering& rendering,
                                                            const std::filesystem::path& folder,
                                                            const RenderingRun& run = {});

/// The solids as the view shows them, in its pose, exploded, without hidden ones; the camera, the section and
/// lines are not included. Nodes have the names of their links. Incomplete if `stop` was requested meanwhile.
[[nodiscard]] MeshScene sceneOf(const MechanismScene& stage, const SceneView& view,
                                const std::stop_token& stop = {});

}  // namespace geargraph
