// The pictures of a rendering as files.

#include <memory>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/foundations/platform/system.h"
#include "core/presentation/mechanism_scene/scene_picture.h"

namespace geargraph {
namespace {

namespace fs = std::filesystem;
using Failure = std::optional<RenderingFailure>;

std::string_view textOf(const std::vector<std::uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};  // NOLINT
}

RenderingFailure fileFailure(std::string message) {
  return {RenderingFailure::Kind::file, std::move(message)};
}

RenderingFailure noMemory() {
  return {RenderingFailure::Kind::graphics, translated("The memory does not suffice for the pictures.")};
}

RenderingFailure stopped() {
  return {RenderingFailure::Kind::stopped, translated("The export was stopped.")};
}

/// Paints one picture after the other and gives each to `take`, which returns what went wrong.
template <class Take>
Failure forEachPicture(ScenePainter& painter, const RenderingRun& run, Take take) {
  for (int picture = 0; picture < painter.pictures(); ++picture) {
    Image image = painter.paint(picture);
    if (run.stop.stop_requested()) return stopped();
    if (image.rgba.empty())
      return RenderingFailure{RenderingFailure::Kind::graphics, translated("The driver painted nothing.")};
    if (run.finish) run.finish(image, painter);
    if (run.stop.stop_requested()) return stopped();
    if (image.rgba.empty())
      return RenderingFailure{RenderingFailure::Kind::graphics,
                              translated("The memory does not suffice for the labels.")};
    Failure failure = take(image, picture);
    if (run.stop.stop_requested()) return stopped();
    if (failure) return failure;
    if (run.progress) run.progress(picture + 1, painter.pictures());
  }
  return std::nullopt;
}

/// Gives the picture's PNG to `write`.
template <class Write>
Failure writePng(const Image& image, const std::stop_token& stop, Write write) {
  const std::vector<std::uint8_t> png = pngBytes(image, stop);
  return png.empty() ? Failure(noMemory()) : write(textOf(png));
}

Failure paintInto(ScenePainter& painter, const RenderingRun& run, ByteSink& sink) {
  if (painter.pictures() == 1) {
    return forEachPicture(painter, run, [&](const Image& image, int) -> Failure {
      return writePng(image, run.stop, [&](std::string_view png) {
        sink.write(png);
        return Failure();
      });
    });
  }
  AnimatedPng animatedPng(painter.pictures(), painter.rendering().animation->framesPerSecond);
  Failure failure = forEachPicture(painter, run, [&](const Image& image, int) -> Failure {
    const std::string bytes = animatedPng.add(image, run.stop);
    if (bytes.empty()) return noMemory();
    sink.write(bytes);
    return sink.failed() ? std::optional(fileFailure(translated("The file could not be written.")))
                         : std::nullopt;
  });
  if (!failure) sink.write(animatedPng.end());
  return failure;
}

/// A folder that goes again with all that is in it.
class ScratchFile {
 public:
  explicit ScratchFile(fs::path path) : m_path(std::move(path)) {
    std::error_code error;
    m_made = fs::create_directories(m_path, error);
  }
  ~ScratchFile() {
    std::error_code error;
    if (m_made) fs::remove_all(m_path, error);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  [[nodiscard]] bool isMade() const { return m_made; }
  [[nodiscard]] const fs::path& path() const { return m_path; }

 private:
  fs::path m_path;
  bool m_made = false;
};

std::string pictureName(int picture) {
  std::string digits = std::to_string(picture + 1);
  return std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits + ".png";
}

Failure moveIn(const fs::path& from, const fs::path& folder, int count) {
  std::error_code error;
  if (!fs::exists(folder, error)) {
    fs::rename(from, folder, error);
    return error ? std::optional(
                       fileFailure(translated("The folder \"%1\" could not be made.", {folder.string()})))
                 : std::nullopt;
  }
  for (int picture = 0; picture < count; ++picture) {
    fs::rename(from / pictureName(picture), folder / pictureName(picture), error);
    if (error)
      return fileFailure(
          translated("\"%1\" could not be written.", {(folder / pictureName(picture)).string()}));
  }
  return std::nullopt;
}

Failure graphicsFailure(const Diagnostics& why) {
  return RenderingFailure{RenderingFailure::Kind::graphics, why.front().message};
}

}  // namespace

Failure writePicture(const SceneRendering& rendering, const fs::path& path, const RenderingRun& run) {
  auto painter = ScenePainter::create(rendering, run.stop);
  if (!painter) return graphicsFailure(painter.error());
  if (*painter == nullptr) return stopped();
  if (path == "-") {
    StandardOutput out;
    Failure failure = paintInto(**painter, run, out);
    if (!failure && out.failed()) failure = fileFailure(translated("Standard output could not be written."));
    return failure;
  }
  AtomicFile file(path);
  if (Failure failure = paintInto(**painter, run, file)) {
    const bool isFile = failure->kind == RenderingFailure::Kind::file;
    if (const auto why = isFile ? file.commit() : std::nullopt) failure->message = why->message;
    return failure;
  }
  if (const auto why = file.commit()) return fileFailure(why->message);
  return std::nullopt;
}

Failure writePictures(const SceneRendering& rendering, const fs::path& folder, const RenderingRun& run) {
  auto painter = ScenePainter::create(rendering, run.stop);
  if (!painter) return graphicsFailure(painter.error());
  if (*painter == nullptr) return stopped();
  std::error_code error;
  const fs::path target = fs::weakly_canonical(folder, error);
  if (fs::exists(target, error) && !fs::is_directory(target, error))
    return fileFailure(translated("\"%1\" is no folder.", {folder.string()}));
  if (!run.mayOverwrite && fs::is_directory(target, error) && !fs::is_empty(target, error))
    return fileFailure(translated("The folder \"%1\" is not empty; nothing was written.", {folder.string()}));
  const ScratchFile scratch(target.parent_path() /
                            ("." + target.filename().string() + "." + std::to_string(processId()) + ".part"));
  if (!scratch.isMade())
    return fileFailure(translated("No folder could be made beside \"%1\".", {folder.string()}));
  Failure failure = forEachPicture(**painter, run, [&](const Image& image, int picture) -> Failure {
    return writePng(image, run.stop, [&](std::string_view png) {
      const auto why = writeFile(scratch.path() / pictureName(picture), png);
      return why ? Failure(fileFailure(why->message)) : std::nullopt;
    });
  });
  if (!failure) failure = moveIn(scratch.path(), target, (*painter)->pictures());
  return failure;
}

}  // namespace geargraph
