#include "app/cli/view3d_options.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "app/cli/element_words.h"
#include "app/cli/export_forms.h"
#include "core/foundations/base/words.h"
#include "core/presentation/results/rendering_names.h"

namespace geargraph::cli {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kMaxTime = 1e9;  // s

std::optional<double> numberIn(std::string_view text, double least, double most) {
  const auto value = numberFrom<double>(text);
  return value && *value >= least && *value <= most ? value : std::nullopt;
}

std::vector<std::string> parts(std::string_view text, char between) {
  std::vector<std::string> result;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(between, begin), text.size());
    result.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

/// Reads options one by one into a rendering; the first that is wrong stays said.
class RenderingReader {
 public:
  explicit RenderingReader(const Arguments& arguments) : m_arguments(arguments) {}

  std::variant<StageRendering, UsageError> read() {
    readSize();
    readCamera();
    readMoment();
    readStyle();
    readAnimation();
    if (m_error) return *m_error;
    return std::move(m_rendering);
  }

 private:
  void wrong(const std::string& message) {
    if (!m_error) m_error = UsageError{message};
  }

  void readSize() {
    const auto text = m_arguments.value("--size");
    if (!text) return;
    if (const auto size = pictureSize(*text, kMaxPictureSide)) {
      m_rendering.size = {size->first, size->second};
    } else {
      wrong(wrongSize(*text, kMaxPictureSide));
    }
  }

  void readCamera() {
    if (m_arguments.has("--from") && m_arguments.has("--camera"))
      return wrong(translated("Give --from or --camera, not both."));
    if (const auto text = m_arguments.value("--from")) {
      const auto view = standardViewNamed(*text);
      if (!view) return wrong(translated("--from is one of front, back, left, right, top, bottom, iso."));
      m_rendering.view.camera = Camera::looking(*view);
    }
    if (const auto text = m_arguments.value("--camera")) {
      const std::vector<std::string> angles = parts(*text, ',');
      const auto azimuth = numberIn(angles.front(), -360, 360);
      const auto elevation = angles.size() == 2 ? numberIn(angles[1], -90, 90) : std::nullopt;
      if (!azimuth || !elevation) {
        return wrong(translated("--camera takes AZIMUTH,ELEVATION in degrees, up to 360 and 90, not \"%1\".",
                                {*text}));
      }
      m_rendering.view.camera = Camera::from(*azimuth * kDegree, *elevation * kDegree);
    }
  }

  void readMoment() {
    if (const auto text = m_arguments.value("--time")) {
      const auto time = numberIn(*text, -kMaxTime, kMaxTime);
      if (!time) return wrong(translated("--time takes seconds, not \"%1\".", {*text}));
      m_rendering.view.time = *time;
    }
    if (const auto text = m_arguments.value("--explode")) {
      const auto part = numberIn(*text, 0, 1);
      if (!part) return wrong(translated("--explode takes a part from 0 to 1, not \"%1\".", {*text}));
      m_rendering.view.explosion = *part;
    }
    if (const auto text = m_arguments.value("--section")) readSection(*text);
  }

  void readSection(const std::string& text) {
    const std::vector<std::string> cut = parts(text, ':');
    const std::size_t axis = std::string_view("xyz").find(cut.front());
    const auto place = cut.size() == 2 ? numberIn(cut[1], 0, 1) : std::optional(0.5);
    if (cut.front().size() != 1 || axis == std::string_view::npos || cut.size() > 2 || !place)
      return wrong(
          translated("--section takes x, y or z, and how far along from 0 to 1: y:0.5, not \"%1\".", {text}));
    m_rendering.view.section = SectionChoice{static_cast<int>(axis), *place, false};
  }

  void readStyle() {
    const Theme theme = m_arguments.has("--dark") ? Theme::dark : Theme::light;
    m_rendering.view.style = pictureStyle(theme, m_arguments.has("--transparent"));
    if (const auto text = m_arguments.value("--faces")) {
      const auto faces = facesNamed(*text);
      if (!faces) return wrong(translated("--faces is one of shaded, lines, edges."));
      m_rendering.view.style.faces = *faces;
    }
    for (const std::string& name : parts(m_arguments.value("--show").value_or(""), ',')) {
      OverlayChoice overlay;
      const bool isKnown = showMark(m_rendering.view.marks, name) || showOverlay(overlay, name);
      if (m_arguments.has("--show") && !isKnown) {
        wrong(translated(
            "--show names labels, joint-labels, axis-labels, scale, pitch-circles, pitch-points, axes, "
            "instant-axes, velocities, forces, power, with commas."));
      }
    }
  }

  void readAnimation() {
    const bool turns = m_arguments.has("--turntable"), moves = m_arguments.has("--motion");
    if (turns && moves) return wrong(translated("Give --turntable or --motion, not both."));
    if (!turns && !moves) return;
    Animation animation;
    animation.kind = turns ? AnimationKind::turntable : AnimationKind::motion;
    const std::string frames = m_arguments.value("--frames").value_or(std::to_string(animation.frames));
    const auto count = numberIn(frames, 2, kMaxAnimationFrames);
    if (!count || *count != std::floor(*count)) {
      return wrong(translated("--frames takes a whole number from 2 to %1, not \"%2\".",
                              {std::to_string(kMaxAnimationFrames), frames}));
    }
    animation.frames = static_cast<int>(*count);
    if (const auto text = m_arguments.value("--fps")) {
      const auto rate = numberIn(*text, 0.1, 100);
      if (!rate)
        return wrong(translated("--fps takes pictures a second from 0.1 to 100, not \"%1\".", {*text}));
      animation.framesPerSecond = *rate;
    }
    m_rendering.animation = animation;
  }

  const Arguments& m_arguments;
  StageRendering m_rendering;
  std::optional<UsageError> m_error;
};

std::optional<ElementId> idOfLink(const Mechanism& mechanism, std::string_view word) {
  const auto link = linkNamed(mechanism, word);
  return link ? std::optional<ElementId>(mechanism.links[*link].id) : std::nullopt;
}

}  // namespace

OverlayChoice overlayOf(const Arguments& arguments) {
  OverlayChoice choice;
  for (const std::string& name : parts(arguments.value("--show").value_or(""), ','))
    showOverlay(choice, name);
  return choice;
}

std::optional<UsageError> renderingUsageError(const Arguments& arguments) {
  const auto read = RenderingReader(arguments).read();
  const auto* error = std::get_if<UsageError>(&read);
  return error == nullptr ? std::nullopt : std::optional(*error);
}

std::variant<StageRendering, UsageError> renderingFrom(const Arguments& arguments, const StagePtr& stage,
                                                       const AnalysisSnapshot& snapshot) {
  auto read = RenderingReader(arguments).read();
  auto* rendering = std::get_if<StageRendering>(&read);
  if (rendering == nullptr) return read;
  rendering->stage = stage;
  const Mechanism& mechanism = *snapshot.mechanism;
  const auto unknown = [](const std::string& label) {
    return UsageError{translated("There is no link \"%1\".", {label})};
  };
  if (const auto label = arguments.value("--ride")) {
    rendering->view.referenceLink = idOfLink(mechanism, *label);
    if (!rendering->view.referenceLink) return unknown(*label);
  }
  if (const auto labels = arguments.value("--hide")) {
    for (const std::string& label : parts(*labels, ',')) {
      const auto link = idOfLink(mechanism, label);
      if (!link) return unknown(label);
      rendering->view.hidden.insert(*link);
    }
  }
  return read;
}

}  // namespace geargraph::cli
