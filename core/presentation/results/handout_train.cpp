#include "core/presentation/results/handout_train.h"

#include "core/foundations/base/words.h"
#include "core/presentation/train_stage/stage_picture.h"
#include "core/presentation/train_stage/train_stage.h"

namespace geargraph::inline results {

MadeHandoutTrain handoutTrain(const AnalysisSnapshot& snapshot, const std::filesystem::path& folder,
                              const std::stop_token& stop) {
  GearCache cache;
  ShapeCache read;
  const ShapeSource shapes{read, folder, stop};
  MadeHandoutTrain made{{trainStage(snapshot, cache, &shapes, nullptr, stop), {}}, {}};
  const StagePtr& stage = made.train.stage;
  if (!stage || stage->scene.instances.empty() || stop.stop_requested()) return made;
  for (const StageNote& note : stage->notes) made.notes.push_back(note.text);
  StageRendering rendering;
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

}  // namespace geargraph::inline results
