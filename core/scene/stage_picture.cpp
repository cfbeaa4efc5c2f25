#include "core/scene/stage_picture.h"

#include <algorithm>

#include "core/render/egl_host.h"

namespace geargraph {

Expected<Image> stagePicture(const Stage& stage, const PictureOptions& options) {
  auto made = EglHost::create();
  if (!made) return made.error();
  EglHost& host = **made;
  if (std::max(options.size.width, options.size.height) > host.maximumSide()) {
    Diagnostic tooLarge;
    tooLarge.code = Code::graphics;
    tooLarge.message = "The driver paints pictures of up to " + std::to_string(host.maximumSide()) +
                       " pixels a side; choose a smaller size.";
    return tooLarge;
  }
  Scene scene = stage.scene;
  if (stage.place && !scene.instances.empty()) {
    std::vector<double> angles;
    for (const double speed : stage.inputSpeeds) angles.push_back(speed * options.time);
    std::vector<Pose> poses(scene.instances.size());
    stage.place(angles, poses);
    for (std::size_t i = 0; i < poses.size(); ++i) scene.instances[i].pose = poses[i];
  }
  host.setScene(scene);
  Frame frame;
  frame.viewport = options.size;
  frame.pixelRatio = std::max(1.0, options.size.height / 600.0);
  frame.look = options.theme == Theme::dark ? Look::dark() : Look::light();
  frame.look.transparent = options.transparent;
  if (options.transparent) frame.look.discStrength = 0;  // the shadow alone says where the floor is
  frame.look.samples = 8;
  const Camera from = options.from ? Camera::looking(*options.from) : Camera::home();
  frame.camera = from.fitted(cornersOf(scene), options.size, 0.07);
  return host.picture(frame);
}

}  // namespace geargraph
