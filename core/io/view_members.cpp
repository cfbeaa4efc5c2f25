#include "core/io/view_members.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "core/io/json_object.h"
#include "core/io/json_writer.h"

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;
constexpr std::string_view kCamera = "camera", kShapes = "shapes";

const std::string* textOf(const UnknownMembers& members, std::string_view name) {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const auto& member) { return member.first == name; });
  return found == members.end() ? nullptr : &found->second;
}

/// In its old place where there was one, so that a saved file reads as it did; without a text it goes.
void setText(UnknownMembers& members, std::string_view name, std::string text) {
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const auto& member) { return member.first == name; });
  if (text.empty()) {
    if (found != members.end()) members.erase(found);
  } else if (found != members.end()) {
    found->second = std::move(text);
  } else {
    members.emplace_back(name, std::move(text));
  }
}

/// One line of JSON, as unknown members are kept.
template <class Write>
std::string written(Write write) {
  TextSink sink;
  {
    JsonWriter json(sink);
    write(json);
  }
  std::string text = sink.take();
  const auto document = JsonDocument::parse(text);
  return document->root().compact();
}

double numberOf(std::optional<JsonValue> value) {
  const auto read = value && value->is(JsonKind::number) ? Number::fromText(value->slice()) : std::nullopt;
  return read ? read->value() : std::numeric_limits<double>::quiet_NaN();
}

/// As it was written where JSON can say it, as in the rest of the file.
void writeNumber(JsonWriter& json, const Number& number) {
  if (isJsonNumber(number.text())) {
    json.json(number.text());
  } else {
    json.string(number.text());
  }
}

void writeTriple(JsonWriter& json, std::string_view name, const std::optional<NumberTriple>& triple) {
  if (!triple) return;
  json.key(name);
  json.beginArray(Layout::row);
  for (const Number& number : *triple) writeNumber(json, number);
  json.endArray();
}

void writeShape(JsonWriter& json, const LinkShape& shape) {
  json.beginObject(Layout::row);
  json.member("file", shape.file);
  writeTriple(json, "position", shape.position);
  writeTriple(json, "orientation", shape.orientation);
  if (shape.scale) {
    json.key("scale");
    writeNumber(json, *shape.scale);
  }
  for (const auto& [name, text] : shape.unknown) {
    json.key(name);
    json.json(text);
  }
  json.endObject();
}

LinkShape readShape(JsonObject& from) {
  LinkShape shape;
  constexpr std::string_view kExpected = "a path that stays in the folder of this document";
  const auto file = from.required("file", kExpected);
  shape.file = from.shortText("file").value_or("");
  if (file && file->is(JsonKind::string) && !staysInFolder(shape.file)) from.wrong("file", *file, kExpected);
  shape.position = from.triple("position");
  shape.orientation = from.triple("orientation");
  const auto scale = from.member("scale");
  shape.scale = from.number("scale");
  if (shape.scale && shape.scale->exact().sign() <= 0) from.wrong("scale", *scale, "a number above 0");
  shape.unknown = from.unknown();
  return shape;
}

Diagnostic refusal(Code code, std::string message, LinkId link) {
  return {code, std::move(message), {link}, {}, 0, 0};
}

}  // namespace

std::optional<ViewCamera> viewCamera(const View& view) {
  const std::string* text = textOf(view.unknown, kCamera);
  if (text == nullptr) return std::nullopt;
  const auto document = JsonDocument::parse(*text);
  if (!document || !document->root().is(JsonKind::object)) return std::nullopt;
  const JsonValue value = document->root();
  ViewCamera camera;
  camera.azimuth = numberOf(value.member("azimuth"));
  camera.elevation = numberOf(value.member("elevation"));
  camera.distance = numberOf(value.member("distance"));
  const auto target = value.member("target");
  if (!target || !target->is(JsonKind::array) || target->size() != camera.target.size()) return std::nullopt;
  double sum = camera.azimuth + camera.elevation;
  target->forEachElement(
      [&](JsonValue element, std::size_t i) { sum += camera.target[i] = numberOf(element); });
  if (!std::isfinite(sum) || !(camera.distance > 0)) return std::nullopt;
  return camera;
}

View withCamera(View view, const ViewCamera& camera) {
  setText(view.unknown, kCamera, written([&](JsonWriter& json) {
            json.beginObject(Layout::row);
            json.key("target");
            json.beginArray(Layout::row);
            for (const double coordinate : camera.target) json.number(coordinate);
            json.endArray();
            json.member("azimuth", camera.azimuth);
            json.member("elevation", camera.elevation);
            json.member("distance", camera.distance);
            json.endObject();
          }));
  return view;
}

Expected<std::vector<LinkShape>> linkShapes(const Link& link) {
  std::vector<LinkShape> shapes;
  const std::string* text = textOf(link.unknown, kShapes);
  if (text == nullptr) return shapes;
  const auto document = JsonDocument::parse(*text);
  if (!document) return document.error();
  if (!document->root().is(JsonKind::array))
    return refusal(Code::schema, "expected a list of the 3D files that the link wears.", link.id);
  JsonFindings findings(*document);
  document->root().forEachElement([&](JsonValue value, std::size_t position) {
    JsonObject from(findings, value, "/shapes" + pointerStep(position));
    from.blame(link.id);
    shapes.push_back(readShape(from));
  });
  if (!findings.empty()) return findings.inOrder();
  return shapes;
}

Expected<Mechanism> withShapes(Mechanism mechanism, LinkId link, const std::vector<LinkShape>& shapes) {
  const auto found = std::find_if(mechanism.links.begin(), mechanism.links.end(),
                                  [&](const Link& each) { return each.id == link; });
  if (found == mechanism.links.end())
    return refusal(Code::unknownId, "There is no \"" + link.text() + "\" in links.", link);
  for (const LinkShape& shape : shapes) {
    if (!staysInFolder(shape.file)) {
      return refusal(Code::schema,
                     "\"" + shape.file +
                         "\" is not in the folder of the document: save the document first, then copy the 3D "
                         "file into its folder.",
                     link);
    }
    if (shape.scale && shape.scale->exact().sign() <= 0)
      return refusal(Code::schema, "The scale of a 3D file has to be above 0.", link);
  }
  setText(found->unknown, kShapes, shapes.empty() ? std::string() : written([&](JsonWriter& json) {
            json.beginArray(Layout::row);
            for (const LinkShape& shape : shapes) writeShape(json, shape);
            json.endArray();
          }));
  return mechanism;
}

bool staysInFolder(std::string_view path) {
  if (path.empty() || path.front() == '/' || path.front() == '\\') return false;
  if (path.size() >= 2 && path[1] == ':' && std::isalpha(static_cast<unsigned char>(path[0])) != 0)
    return false;
  int depth = 0;  // folders below the first
  while (!path.empty()) {
    const std::size_t end = std::min(path.find_first_of("/\\"), path.size());
    const std::string_view step = path.substr(0, end);
    if (step == "..") {
      if (--depth < 0) return false;
    } else if (!step.empty() && step != ".") {
      ++depth;
    }
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return true;
}

}  // namespace geargraph
