#include "core/presentation/export_api/handout_train.h"

#include "core/foundations/base/translation.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/mechanism_scene/scene_picture.h"

namespace geargraph {

MadeHandoutTrain handoutTrain(const AnalysisSnapshot& snapshot, const std::filesystem::path& folder,
                              const std::stop_token& stop) {
  GearCache cache;
  ShapeCache read;
  const ShapeSource shapes{read, folder, stop};
  MadeHandoutTrain made{{mechanismScene(snapshot, cache, &shapes, nullptr, stop), {}}, {}};
  const MechanismScenePtr& stage = made.train.stage;
  if (!stage || stage->scene.instances.empty() || stop.stop_requested()) return made;
  for (const SceneNote& note : stage->notes) made.notes.push_back(note.text);
  SceneRendering rendering;
  rendering.stage = stage;
  rendering.size = {720, 480};
  rendering.view.style = pictureStyle(Theme::light, false);
  if (const Expected<Image> picture = stagePicture(std::move(rendering))) {
    const std::vector<std::uint8_t> png = pngBytes(*picture, stop);
    made.train.still.assign(png.begin(), png.end());
  } else {
    made.notes.push_back(
        translated("The handout has no still picture: %1", {picture.error().front().message}));
  }
  return made;
}

}  // namespace geargraph
