#include "core/mechanism/document_format/view_reader.h"

#include <cmath>

#include "core/foundations/base/translation.h"
#include "core/mechanism/document_format/element_reader.h"
#include "core/mechanism/model/fields.h"

namespace geargraph {
namespace {

class ViewReader {
 public:
  ViewReader(JsonDiagnostics& diagnostics, const MemberInfo& info, JsonValue value)
      : m_diagnostics(diagnostics), m_from(diagnostics, value, pointerStep(info.name)) {}

  View run() {
    View view;
    forEachField<View>([&](const auto& field) { read(field.info(), view.*field.member); });
    view.unknown = m_from.unknown();
    return view;
  }

 private:
  void read(const MemberInfo& info, std::map<LinkId, CanvasPoint>& nodes) {
    const auto value = m_from.member(info.name);
    if (!value) return;
    if (!value->is(JsonKind::object))
      return m_from.wrong(info.name, *value, toTranslate("an object of points by the id of their link"));
    value->forEachMember([&](JsonValue key, JsonValue point) {
      if (const auto at = coordinatesOf<2>(point)) {
        nodes[LinkId(key.string())] = {(*at)[0], (*at)[1]};
        return;
      }
      const std::string pointer = pointerTo(info) + pointerStep(key.string());
      if (m_diagnostics.covers(pointer)) return;
      m_diagnostics.add(
          Code::schema,
          translated("expected the point of a node: a list of two numbers, x to the right and y down."), {},
          pointer, point);
    });
  }

  void read(const MemberInfo& info, std::map<LinkId, int>& numbers) {
    const auto object = m_from.member(info.name);
    if (!object) return;
    if (!object->is(JsonKind::object))
      return m_from.wrong(info.name, *object,
                          toTranslate("an object of whole numbers by the id of their link"));
    object->forEachMember([&](JsonValue key, JsonValue value) {
      const auto number = finiteNumber(value);
      if (number && *number >= 1 && *number <= kMaxColorNumber && *number == std::floor(*number)) {
        numbers[LinkId(key.string())] = static_cast<int>(*number);
        return;
      }
      const std::string pointer = pointerTo(info) + pointerStep(key.string());
      if (m_diagnostics.covers(pointer)) return;
      m_diagnostics.add(Code::schema,
                        translated("expected the number of a link's colour: a whole number from 1 on."), {},
                        pointer, value);
    });
  }

  void read(const MemberInfo& info, std::vector<CanvasNote>& notes) {
    const auto list = m_from.member(info.name);
    const std::string pointer = pointerTo(info);
    if (!list || m_diagnostics.covers(pointer)) return;  // too long: said already
    if (!list->is(JsonKind::array)) return m_from.wrong(info.name, *list, info.expected);
    list->forEachElement([&](JsonValue value, std::size_t position) {
      JsonObject from(m_diagnostics, value, pointer + pointerStep(position));
      CanvasNote& note = notes.emplace_back();
      note.id = NoteId(from.requiredId("id"));
      if (!note.id.empty()) from.blame(note.id);
      readMembers(from, note);
      note.unknown = from.unknown();
    });
  }

  void read(const MemberInfo& info, std::optional<ViewCamera>& camera) {
    const auto value = m_from.member(info.name);
    if (!value) return;
    JsonObject from(m_diagnostics, *value, pointerTo(info));
    readMembers(from, camera.emplace());
    camera->unknown = from.unknown();
  }

  [[nodiscard]] std::string pointerTo(const MemberInfo& info) const {
    return m_from.pointer() + pointerStep(info.name);
  }

  JsonDiagnostics& m_diagnostics;
  JsonObject m_from;
};

}  // namespace

View readView(JsonDiagnostics& diagnostics, const MemberInfo& info, JsonValue value) {
  return ViewReader(diagnostics, info, value).run();
}

}  // namespace geargraph
