// Drawings and 3D pictures.

#include <filesystem>
#include <numbers>

#include "app/python/bindings/snapshot.h"
#include "core/presentation/cairo_output/picture.h"
#include "core/presentation/export_api/named_drawings.h"
#include "core/presentation/export_api/rendering_names.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/mechanism_scene/scene_picture.h"
#include "core/presentation/meshfile/mesh_writer.h"

namespace geargraph::python {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

using Size = std::optional<std::pair<int, int>>;

void checkSize(const Size& size, int most) {
  if (!size) return;
  for (const int side : {size->first, size->second}) {
    if (side < kLeastPictureSide || side > most) {
      throw py::value_error("The sides of a picture are " + std::to_string(kLeastPictureSide) + " to " +
                            std::to_string(most) + " pixels.");
    }
  }
}

py::bytes drawing(const Snapshot& self, const std::string& name, const std::string& form, bool dark,
                  bool transparent, const Size& size) {
  const NamedDrawing* const found = drawingNamed(name);
  if (found == nullptr)
    throw py::value_error("A drawing is one of " + drawingNames() + ", not \"" + name + "\".");
  const auto pictureForm = pictureFormFromName(form);
  if (!pictureForm) throw py::value_error("A drawing is written as svg, pdf or png, not \"" + form + "\".");
  checkSize(size, kMaxDrawingPixels);
  DrawingPicture picture;
  picture.form = *pictureForm;
  picture.style.theme = dark ? Theme::dark : Theme::light;
  picture.style.transparent = transparent;
  if (size) picture.style.size = SheetStyle::Size{size->first, size->second};
  picture.title = self.mechanism().name;
  return bytesOf(valueOrRaise(interruptible([&](const std::stop_token& stop) {
    return pictureOf(found->draw(*self.live(), nullptr, stop), picture);
  })));
}

/// What a 3D picture shows, as Python gives it.
struct RequestedPicture {
  Size size;
  bool dark = false;
  bool transparent = false;
  std::optional<std::string> from;
  std::optional<std::pair<double, double>> camera;  ///< azimuth, elevation in degrees
  double time = 0;
  std::optional<std::pair<int, double>> section;
  double explosion = 0;
  std::string faces = "shaded";
  std::vector<std::string> show;
  std::vector<std::string> hide;
  std::optional<std::string> referenceLink;
  std::string folder;
  std::string reader;

  explicit RequestedPicture(const py::dict& requested)
      : size(requested["size"].cast<Size>()),
        dark(requested["dark"].cast<bool>()),
        transparent(requested["transparent"].cast<bool>()),
        from(requested["view"].cast<std::optional<std::string>>()),
        camera(requested["camera"].cast<std::optional<std::pair<double, double>>>()),
        time(requested["time"].cast<double>()),
        section(requested["section"].cast<std::optional<std::pair<int, double>>>()),
        explosion(requested["explode"].cast<double>()),
        faces(requested["faces"].cast<std::string>()),
        show(requested["show"].cast<std::vector<std::string>>()),
        hide(requested["hide"].cast<std::vector<std::string>>()),
        referenceLink(requested["ride"].cast<std::optional<std::string>>()),
        folder(requested["folder"].cast<std::string>()),
        reader(requested["reader"].cast<std::string>()) {}
};

std::pair<SceneRendering, OverlayChoice> renderingFrom(const RequestedPicture& requested) {
  SceneRendering rendering;
  OverlayChoice overlay;
  checkSize(requested.size, kMaxPictureSide);
  if (requested.size) rendering.size = {requested.size->first, requested.size->second};
  if (requested.from) {
    const auto view = standardViewNamed(*requested.from);
    if (!view) throw py::value_error("There is no view \"" + *requested.from + "\".");
    rendering.view.camera = Camera::looking(*view);
  }
  if (requested.camera)
    rendering.view.camera =
        Camera::from(requested.camera->first * kDegree, requested.camera->second * kDegree);
  rendering.view.time = requested.time;
  if (requested.section)
    rendering.view.section = SectionChoice{requested.section->first, requested.section->second, false};
  rendering.view.explosion = requested.explosion;
  rendering.view.style = pictureStyle(requested.dark ? Theme::dark : Theme::light, requested.transparent);
  const auto faces = facesNamed(requested.faces);
  if (!faces) throw py::value_error("There are no faces \"" + requested.faces + "\".");
  rendering.view.style.faces = *faces;
  for (const std::string& name : requested.show) {
    if (!showMark(rendering.view.marks, name) && !showOverlay(overlay, name))
      throw py::value_error("A 3D picture shows no \"" + name + "\".");
  }
  for (const std::string& id : requested.hide) rendering.view.hidden.insert(LinkId(id));
  if (requested.referenceLink) rendering.view.referenceLink = LinkId(*requested.referenceLink);
  return {std::move(rendering), overlay};
}

/// The stage, or raises geargraph.Error where there is nothing to show.
MechanismScenePtr stageOf(const Snapshot& self, const RequestedPicture& requested) {
  if (self.mechanism().n() > kMaxStageLinks)
    raise("limit", "3D is made of up to " + std::to_string(kMaxStageLinks) + " links.");
  MechanismScenePtr stage = interruptible([&](const std::stop_token& stop) {
    GearCache cache;
    ShapeCache read(requested.reader.empty() ? foreignMeshReader() : std::filesystem::path(requested.reader));
    const ShapeSource shapes{read, requested.folder, stop};
    return mechanismScene(*self.live(), cache, &shapes, nullptr, stop);
  });
  if (stage->scene.instances.empty()) self.raiseUndefined("There is nothing to show.");
  return stage;
}

RenderingRun runWith(const OverlayChoice& overlay, bool dark) {
  RenderingRun run;
  if (!overlay.any()) return run;
  run.finish = [labels = SceneLabels(overlay), theme = dark ? Theme::dark : Theme::light](
                   Image& image, ScenePainter& painter) mutable {
    if (!paintOver(image.rgba, image.width, image.height, labels.over(painter), painter.pixelRatio(), theme))
      image.rgba.clear();
  };
  return run;
}

/// The PNG, and what is not shown or simplified, with the reasons.
py::tuple picture(const Snapshot& self, const py::dict& options) {
  const RequestedPicture requested(options);
  auto [made, overlay] = renderingFrom(requested);
  SceneRendering rendering = std::move(made);
  const MechanismScenePtr stage = rendering.stage = stageOf(self, requested);
  RenderingRun run = runWith(overlay, requested.dark);
  using Bytes = std::vector<std::uint8_t>;
  const auto png = valueOrRaise(interruptible([&](const std::stop_token& stop) -> Expected<Bytes> {
    auto created = ScenePainter::create(std::move(rendering), stop);
    if (!created) return created.error();
    if (!*created) return Bytes();  // stopped
    ScenePainter& painter = **created;
    Image image = painter.paint(0);
    if (run.finish && !image.rgba.empty()) run.finish(image, painter);
    return pngBytes(image, stop);
  }));
  if (png.empty()) raise("graphics", "The memory does not suffice for the picture.");
  py::list notes;
  for (const SceneNote& note : stage->notes) notes.append(note.text);
  return py::make_tuple(packed(png), notes);
}

/// Where an animation goes: an animated PNG, or a folder of its pictures.
struct AnimationPlace {
  std::string path;
  bool isFolder = false;
  bool mayOverwrite = false;
};

/// `kind`: "turntable" or "motion".
void writeAnimation(const Snapshot& self, const py::dict& options, const AnimationPlace& place,
                    const std::string& kind, int frames, double framesPerSecond) {
  const RequestedPicture requested(options);
  auto [made, overlay] = renderingFrom(requested);
  SceneRendering rendering = std::move(made);
  if (frames < 2 || frames > kMaxAnimationFrames)
    throw py::value_error("A film has 2 to " + std::to_string(kMaxAnimationFrames) + " frames.");
  rendering.animation = Animation{kind == "motion" ? AnimationKind::motion : AnimationKind::turntable, frames,
                                  framesPerSecond, 0};
  rendering.stage = stageOf(self, requested);
  RenderingRun run = runWith(overlay, requested.dark);
  const auto failure = interruptible([&](const std::stop_token& stop) {
    run.stop = stop;
    run.mayOverwrite = place.mayOverwrite;
    return place.isFolder ? geargraph::writePictures(rendering, place.path, run)
                          : geargraph::writePicture(rendering, place.path, run);
  });
  if (failure) raise(failure->kind == RenderingFailure::Kind::file ? "file" : "graphics", failure->message);
}

/// GLB: the solids as the view shows them.
void writeView(const Snapshot& self, const py::dict& options, const std::string& path) {
  const RequestedPicture requested(options);
  auto [rendering, overlay] = renderingFrom(requested);
  const MechanismScenePtr stage = stageOf(self, requested);
  const SceneView& view = rendering.view;
  const auto error = interruptible([&](const std::stop_token& stop) {
    MeshWriteOptions writing;
    writing.stop = stop;
    return writeMesh(sceneOf(*stage, view, stop), MeshFormat::glb, path, writing);
  });
  if (error) raise(error->kind == MeshFileError::Kind::limit ? "limit" : "file", error->message);
}

}  // namespace

void addPictures(py::module_& module) {
  py::class_<Snapshot, std::shared_ptr<Snapshot>>(module.attr("Snapshot"))
      .def("drawing", drawing)
      .def("picture", picture)
      .def("film",
           [](const Snapshot& self, const py::dict& options, const std::string& path, bool isFolder,
              bool mayOverwrite, const std::string& kind, int frames, double framesPerSecond) {
             writeAnimation(self, options, {path, isFolder, mayOverwrite}, kind, frames, framesPerSecond);
           })
      .def("write_view", writeView);
}

}  // namespace geargraph::python
