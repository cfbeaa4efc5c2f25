#include "core/presentation/exporters/view3d_options.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "core/foundations/base/translation.h"
#include "core/presentation/export_api/rendering_names.h"
#include "core/presentation/exporters/element_words.h"

namespace geargraph {
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
  explicit RenderingReader(const OptionValues& given) : m_given(given) {}

  std::variant<SceneRendering, UsageError> read() {
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
    const auto text = m_given.value("--size");
    if (!text) return;
    if (const auto size = pictureSize(*text, kMaxPictureSide)) {
      m_rendering.size = {size->first, size->second};
    } else {
      wrong(wrongSize(*text, kMaxPictureSide));
    }
  }

  void readCamera() {
    if (m_given.has("--from") && m_given.has("--camera"))
      return wrong(translated("Give --from or --camera, not both."));
    if (const auto text = m_given.value("--from")) {
      const auto view = standardViewNamed(*text);
      if (!view) return wrong(translated("--from is one of front, back, left, right, top, bottom, iso."));
      m_rendering.view.camera = Camera::looking(*view);
    }
    if (const auto text = m_given.value("--camera")) {
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
    if (const auto text = m_given.value("--time")) {
      const auto time = numberIn(*text, -kMaxTime, kMaxTime);
      if (!time) return wrong(translated("--time takes seconds, not \"%1\".", {*text}));
      m_rendering.view.time = *time;
    }
    if (const auto text = m_given.value("--explode")) {
      const auto part = numberIn(*text, 0, 1);
      if (!part) return wrong(translated("--explode takes a part from 0 to 1, not \"%1\".", {*text}));
      m_rendering.view.explosion = *part;
    }
    if (const auto text = m_given.value("--section")) readSection(*text);
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
    const Theme theme = m_given.has("--dark") ? Theme::dark : Theme::light;
    m_rendering.view.style = pictureStyle(theme, m_given.has("--transparent"));
    if (const auto text = m_given.value("--faces")) {
      const auto faces = facesNamed(*text);
      if (!faces) return wrong(translated("--faces is one of shaded, lines, edges."));
      m_rendering.view.style.faces = *faces;
    }
    for (const std::string& name : parts(m_given.value("--show").value_or(""), ',')) {
      OverlayChoice overlay;
      const bool isKnown = showMark(m_rendering.view.marks, name) || showOverlay(overlay, name);
      if (m_given.has("--show") && !isKnown) {
        wrong(translated(
            "--show names labels, joint-labels, axis-labels, scale, pitch-circles, pitch-points, axes, "
            "instant-axes, velocities, forces, power, with commas."));
      }
    }
  }

  void readAnimation() {
    const bool turns = m_given.has("--turntable"), moves = m_given.has("--motion");
    if (turns && moves) return wrong(translated("Give --turntable or --motion, not both."));
    if (!turns && !moves) return;
    Animation animation;
    animation.kind = turns ? AnimationKind::turntable : AnimationKind::motion;
    const std::string frames = m_given.value("--frames").value_or(std::to_string(animation.frames));
    const auto count = numberIn(frames, 2, kMaxAnimationFrames);
    if (!count || *count != std::floor(*count)) {
      return wrong(translated("--frames takes a whole number from 2 to %1, not \"%2\".",
                              {std::to_string(kMaxAnimationFrames), frames}));
    }
    animation.frames = static_cast<int>(*count);
    if (const auto text = m_given.value("--fps")) {
      const auto rate = numberIn(*text, 0.1, 100);
      if (!rate)
        return wrong(translated("--fps takes pictures a second from 0.1 to 100, not \"%1\".", {*text}));
      animation.framesPerSecond = *rate;
    }
    m_rendering.animation = animation;
  }

  const OptionValues& m_given;
  SceneRendering m_rendering;
  std::optional<UsageError> m_error;
};

std::optional<ElementId> idOfLink(const Mechanism& mechanism, std::string_view word) {
  const auto link = linkNamed(mechanism, word);
  return link ? std::optional<ElementId>(mechanism.links[*link].id) : std::nullopt;
}

}  // namespace

std::optional<std::pair<int, int>> pictureSize(std::string_view text, int most) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  const auto width = numberFrom<int>(text.substr(0, cross)), height = numberFrom<int>(text.substr(cross + 1));
  const auto fits = [most](const auto& side) { return side && *side >= kLeastPictureSide && *side <= most; };
  if (!fits(width) || !fits(height)) return std::nullopt;
  return std::pair(*width, *height);
}

std::string wrongSize(std::string_view text, int most) {
  return translated("--size takes WIDTHxHEIGHT, each from %1 to %2, not \"%3\".",
                    {std::to_string(kLeastPictureSide), std::to_string(most), text});
}

OverlayChoice overlayOf(const OptionValues& given) {
  OverlayChoice choice;
  for (const std::string& name : parts(given.value("--show").value_or(""), ',')) showOverlay(choice, name);
  return choice;
}

std::optional<UsageError> renderingUsageError(const OptionValues& given) {
  const auto read = RenderingReader(given).read();
  const auto* error = std::get_if<UsageError>(&read);
  return error == nullptr ? std::nullopt : std::optional(*error);
}

std::variant<SceneRendering, UsageError> renderingFrom(const OptionValues& given,
                                                       const MechanismScenePtr& stage,
                                                       const AnalysisSnapshot& snapshot) {
  auto read = RenderingReader(given).read();
  auto* rendering = std::get_if<SceneRendering>(&read);
  if (rendering == nullptr) return read;
  rendering->stage = stage;
  const Mechanism& mechanism = *snapshot.mechanism;
  const auto unknown = [](const std::string& label) {
    return UsageError{translated("There is no link \"%1\".", {label})};
  };
  if (const auto label = given.value("--ride")) {
    rendering->view.referenceLink = idOfLink(mechanism, *label);
    if (!rendering->view.referenceLink) return unknown(*label);
  }
  if (const auto labels = given.value("--hide")) {
    for (const std::string& label : parts(*labels, ',')) {
      const auto link = idOfLink(mechanism, label);
      if (!link) return unknown(label);
      rendering->view.hidden.insert(*link);
    }
  }
  return read;
}

}  // namespace geargraph
