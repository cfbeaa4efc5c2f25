#include "core/mechanism/document_format/view_reader.h"

#include <array>
#include <cmath>

#include "core/foundations/base/words.h"

namespace geargraph::inline document_format {
namespace {

using Nodes = std::map<LinkId, SheetPoint>;

LinkShape readShape(JsonObject& from) {
  LinkShape shape;
  (void)from.required("file", toTranslate("a path that stays in the folder of this document"));
  shape.file = from.shortText("file").value_or("");
  shape.position = from.triple("position");
  shape.orientation = from.triple("orientation");
  shape.scale = from.number("scale");
  shape.unknown = from.unknown();
  return shape;
}

std::optional<double> finite(JsonValue value) {
  const auto number = value.is(JsonKind::number) ? Number::fromText(value.slice()) : std::nullopt;
  if (!number || !std::isfinite(number->value())) return std::nullopt;
  return number->value();
}

/// The coordinates of a list of `N` finite numbers.
template <std::size_t N>
std::optional<std::array<double, N>> coordinatesOf(JsonValue value) {
  if (!value.is(JsonKind::array) || value.size() != N) return std::nullopt;
  std::array<double, N> coordinates{};
  bool complete = true;
  value.forEachElement([&](JsonValue element, std::size_t i) {
    const auto number = finite(element);
    complete = complete && number.has_value();
    coordinates[i] = number.value_or(0);
  });
  return complete ? std::optional(coordinates) : std::nullopt;
}

class ViewReader {
 public:
  ViewReader(JsonDiagnostics& diagnostics, JsonValue value)
      : m_diagnostics(diagnostics), m_from(diagnostics, value, "/view") {}

  View run() {
    View view;
    view.nodes = nodes("nodes");
    view.ttNodes = nodes("ttNodes");
    if (const auto value = m_from.member("notes")) view.notes = notes(*value);
    if (const auto value = m_from.member("camera")) view.camera = camera(*value);
    if (const auto value = m_from.member("colors")) view.colors = colors(*value);
    view.unknown = m_from.unknown();
    return view;
  }

 private:
  Nodes nodes(std::string_view name) {
    Nodes found;
    const auto value = m_from.member(name);
    if (!value) return found;
    if (!value->is(JsonKind::object)) {
      m_from.wrong(name, *value, toTranslate("an object of points by the id of their link"));
      return found;
    }
    value->forEachMember([&](JsonValue key, JsonValue point) {
      if (const auto at = coordinatesOf<2>(point)) {
        found[LinkId(key.string())] = {(*at)[0], (*at)[1]};
        return;
      }
      const std::string pointer = "/view" + pointerStep(name) + pointerStep(key.string());
      if (m_diagnostics.covers(pointer)) return;
      m_diagnostics.add(
          Code::schema,
          translated("expected the point of a node: a list of two numbers, x to the right and y down."), {},
          pointer, point);
    });
    return found;
  }

  std::map<LinkId, int> colors(JsonValue object) {
    constexpr int kMaxNumber = 1'000'000;
    std::map<LinkId, int> found;
    if (!object.is(JsonKind::object)) {
      m_from.wrong("colors", object, toTranslate("an object of whole numbers by the id of their link"));
      return found;
    }
    object.forEachMember([&](JsonValue key, JsonValue value) {
      const auto number = finite(value);
      if (number && *number >= 1 && *number <= kMaxNumber && *number == std::floor(*number)) {
        found[LinkId(key.string())] = static_cast<int>(*number);
        return;
      }
      const std::string pointer = "/view/colors" + pointerStep(key.string());
      if (m_diagnostics.covers(pointer)) return;
      m_diagnostics.add(Code::schema,
                        translated("expected the number of a link's colour: a whole number from 1 on."), {},
                        pointer, value);
    });
    return found;
  }

  std::vector<SheetNote> notes(JsonValue list) {
    std::vector<SheetNote> found;
    if (m_diagnostics.covers("/view/notes")) return found;  // too long: said already
    if (!list.is(JsonKind::array)) {
      m_from.wrong("notes", list, toTranslate("a list of notes"));
      return found;
    }
    list.forEachElement([&](JsonValue value, std::size_t position) {
      JsonObject from(m_diagnostics, value, "/view/notes" + pointerStep(position));
      SheetNote& note = found.emplace_back();
      note.id = NoteId(from.requiredId("id"));
      if (!note.id.empty()) from.blame(note.id);
      (void)from.required("text", toTranslate("the text of the note"));
      note.text = from.text("text").value_or("");
      if (const auto at = from.required("at", toTranslate("the middle of the note"))) {
        const auto point = coordinatesOf<2>(*at);
        if (!point) from.wrong("at", *at, toTranslate("a list of two numbers, x to the right and y down"));
        // Without the sign of a zero, as edits leave it.
        if (point) note.at = {(*point)[0] + 0.0, (*point)[1] + 0.0};
      }
      note.unknown = from.unknown();
    });
    return found;
  }

  ViewCamera camera(JsonValue value) {
    JsonObject from(m_diagnostics, value, "/view/camera");
    ViewCamera camera;
    if (const auto target = from.required("target", toTranslate("the point that the camera looks at"))) {
      const auto point = coordinatesOf<3>(*target);
      if (!point) from.wrong("target", *target, toTranslate("a list of three numbers"));
      camera.target = point.value_or(camera.target);
    }
    const auto number = [&from](std::string_view name, std::string_view expected) {
      const auto member = from.required(name, expected);
      const auto read = member ? finite(*member) : std::nullopt;
      if (member && !read) from.wrong(name, *member, expected);
      return read;
    };
    camera.azimuth = number("azimuth", toTranslate("an angle in degrees")).value_or(camera.azimuth);
    camera.elevation = number("elevation", toTranslate("an angle in degrees")).value_or(camera.elevation);
    camera.distance = number("distance", toTranslate("a number above 0")).value_or(camera.distance);
    camera.unknown = from.unknown();
    return camera;
  }

  JsonDiagnostics& m_diagnostics;
  JsonObject m_from;
};

}  // namespace

std::vector<LinkShape> readShapes(JsonDiagnostics& diagnostics, JsonValue list, const std::string& pointer,
                                  LinkId link) {
  std::vector<LinkShape> shapes;
  list.forEachElement([&](JsonValue value, std::size_t position) {
    JsonObject from(diagnostics, value, pointer + pointerStep(position));
    from.blame(link);
    shapes.push_back(readShape(from));
  });
  return shapes;
}

View readView(JsonDiagnostics& diagnostics, JsonValue value) {
  return ViewReader(diagnostics, value).run();
}

}  // namespace geargraph::inline document_format
