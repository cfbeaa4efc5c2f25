#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "core/foundations/base/expected.h"
#include "core/presentation/drawing/palette.h"
#include "core/presentation/meshfile/mesh_scene.h"
#include "core/presentation/painting/egl_host.h"
#include "core/presentation/stage/film.h"
#include "core/presentation/stage/label_anchors.h"
#include "core/presentation/stage/stage_view.h"

namespace geargraph::inline train_stage {

/// Sides of a picture in pixels.
constexpr int kLeastPictureSide = 16;
constexpr int kMostPictureSide = 8192;

/// The theme's look as files have it: finely sampled, and on no ground where that is wished (then the shadow
/// alone says where the floor is).
[[nodiscard]] Look pictureLook(Theme theme, bool transparent);

/// A picture or film of a stage that somebody wants.
struct StageShot {
  StagePtr stage;
  StageView view;
  Viewport size{1600, 1000};
  bool fits = true;  ///< the camera keeps its direction and goes where all of the picture or film is in view
  std::optional<Film> film;
  double pixelRatio = 0;  ///< pixels of a logical one, for the widths of lines; 0: by the height
};

/// Paints the pictures of a shot with no display. Use it on the thread that made it.
class StagePainter {
 public:
  /// Fails with `graphics` where nothing can paint, or the driver paints no picture so large. Null when
  /// `stop` was requested meanwhile; later it ends the picture under way, which is empty then. Cost: a
  /// context and shaders; where the shot fits, the outline of each solid and up to 24 poses of a film.
  [[nodiscard]] static Expected<std::unique_ptr<StagePainter>> create(StageShot shot,
                                                                      const std::stop_token& stop = {});

  /// 1 where there is no film.
  [[nodiscard]] int pictures() const { return m_shot.film ? m_shot.film->frames : 1; }
  /// Empty where the driver has no room, or it was stopped.
  [[nodiscard]] Image paint(int picture);
  /// What the last picture shows where, and what labels are placed by with it; the ground refers to the
  /// painter and the map. The map is of no use once stopped. @pre paint() was called
  [[nodiscard]] SeenMap seenForLabels();
  [[nodiscard]] LabelGround labelGround(const SeenMap& seen) const;
  /// What the last picture showed.
  [[nodiscard]] const SeenStage& seen() const { return m_seen; }
  [[nodiscard]] const StageView& view() const { return m_now; }
  [[nodiscard]] double pixelRatio() const;
  [[nodiscard]] const StageShot& shot() const { return m_shot; }

 private:
  StagePainter(StageShot shot, std::stop_token stop, std::unique_ptr<EglHost> host);
  void fit();
  void fitFilm();
  [[nodiscard]] StageView viewOf(int picture) const;
  [[nodiscard]] Frame frame() const;

  StageShot m_shot;
  std::stop_token m_stop;
  std::unique_ptr<EglHost> m_host;
  SeenStage m_seen;
  StageView m_now;
};

/// One picture of the shot; its film is not looked at.
[[nodiscard]] Expected<Image> stagePicture(StageShot shot);

/// Why a shot was not written.
struct ShotFailure {
  enum class Kind { stopped, graphics, file };
  Kind kind = Kind::file;
  std::string message;
};

struct ShotRun {
  std::function<void(int done, int all)> progress;    ///< after each picture, on the caller's thread
  std::stop_token stop;                               ///< ends what is under way, too
  std::function<void(Image&, StagePainter&)> finish;  ///< paints over each picture, labels for one;
                                                      ///< clears it where it cannot
  bool mayOverwrite = false;                          ///< files in a folder that is there already
};

/// The shot as one file, whole or not at all: a PNG, animated where there is a film. "-" is standard output.
[[nodiscard]] std::optional<ShotFailure> writePicture(const StageShot& shot,
                                                      const std::filesystem::path& path,
                                                      const ShotRun& run = {});

/// The film as PNGs in a folder, "0001.png" and on; they come into the folder when all are painted, or not at
/// all.
[[nodiscard]] std::optional<ShotFailure> writePictures(const StageShot& shot,
                                                       const std::filesystem::path& folder,
                                                       const ShotRun& run = {});

/// The solids as the view shows them, in its pose, pulled apart, without what is hidden; the camera, the
/// section and lines are no part of it. Nodes bear the names of their links. Incomplete when `stop` was
/// requested meanwhile.
[[nodiscard]] MeshScene sceneOf(const Stage& stage, const StageView& view, const std::stop_token& stop = {});

}  // namespace geargraph::inline train_stage
