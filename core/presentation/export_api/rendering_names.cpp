#include "core/presentation/export_api/rendering_names.h"

#include <array>
#include <utility>

namespace geargraph {
namespace {

using ViewName = std::pair<std::string_view, StandardView>;
constexpr std::array kViews = {
    ViewName{"front", StandardView::front},  ViewName{"back", StandardView::back},
    ViewName{"left", StandardView::left},    ViewName{"right", StandardView::right},
    ViewName{"top", StandardView::top},      ViewName{"bottom", StandardView::bottom},
    ViewName{"iso", StandardView::isometric}};

using FacesName = std::pair<std::string_view, Faces>;
constexpr std::array kFaces = {FacesName{"shaded", Faces::shaded}, FacesName{"lines", Faces::hiddenLine},
                               FacesName{"edges", Faces::wireframe}};

using MarkName = std::pair<std::string_view, bool MarkChoice::*>;
constexpr std::array kMarks = {MarkName{"pitch-circles", &MarkChoice::pitchCircles},
                               MarkName{"pitch-points", &MarkChoice::pitchPoints},
                               MarkName{"axes", &MarkChoice::axes},
                               MarkName{"instant-axes", &MarkChoice::instantAxes},
                               MarkName{"velocities", &MarkChoice::velocities},
                               MarkName{"forces", &MarkChoice::forces}};

using OverlayName = std::pair<std::string_view, bool OverlayChoice::*>;
constexpr std::array kOverlays = {
    OverlayName{"labels", &OverlayChoice::links},     OverlayName{"joint-labels", &OverlayChoice::joints},
    OverlayName{"axis-labels", &OverlayChoice::axes}, OverlayName{"scale", &OverlayChoice::scaleBar},
    OverlayName{"forces", &OverlayChoice::forces},    OverlayName{"power", &OverlayChoice::power}};

template <class Value, std::size_t Count>
std::optional<Value> named(const std::array<std::pair<std::string_view, Value>, Count>& values,
                           std::string_view name) {
  for (const auto& [known, value] : values) {
    if (known == name) return value;
  }
  return std::nullopt;
}

template <class Choice, std::size_t Count>
bool show(Choice& choice, const std::array<std::pair<std::string_view, bool Choice::*>, Count>& members,
          std::string_view name) {
  const auto member = named(members, name);
  if (member) choice.** member = true;
  return member.has_value();
}

}  // namespace

std::optional<StandardView> standardViewNamed(std::string_view name) {
  return named(kViews, name);
}

std::optional<Faces> facesNamed(std::string_view name) {
  return named(kFaces, name);
}

bool showMark(MarkChoice& marks, std::string_view name) {
  return show(marks, kMarks, name);
}

bool showOverlay(OverlayChoice& overlay, std::string_view name) {
  return show(overlay, kOverlays, name);
}

}  // namespace geargraph
