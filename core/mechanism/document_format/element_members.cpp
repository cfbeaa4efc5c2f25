#include "core/mechanism/document_format/element_members.h"

#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/json_writer.h"
#include "core/mechanism/document_format/element_reader.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph {
namespace {

/// An object with the members of `changes` instead of those of `own`, without those that are null.
std::string changedObject(const std::optional<JsonValue>& own, JsonValue changes,
                          const MemberFilter& isMember) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject(JsonWriter::Layout::row);
    if (own) {
      own->forEachMember([&](JsonValue key, JsonValue value) {
        const std::string name = key.string();
        if (isMember(name) && changes.member(name)) return;
        json.key(name);
        json.json(value.slice());
      });
    }
    changes.forEachMember([&](JsonValue key, JsonValue value) {
      const std::string name = key.string();
      if (!isMember(name) || value.is(JsonKind::null)) return;
      json.key(name);
      json.json(value.slice());
    });
    json.endObject();
  }
  return sink.take();
}

bool hasMember(const UnknownMembers& members, const std::string& name) {
  return std::any_of(members.begin(), members.end(),
                     [&](const auto& member) { return member.first == name; });
}

/// Unknown members are rejected, except those of `kept`.
template <class Element>
Expected<Element> readElement(const std::string& object, const UnknownMembers& kept,
                              const std::string& pointer) {
  const auto document = JsonDocument::parse(object);
  if (!document) return document.error();
  JsonDiagnostics diagnostics(*document);
  checkJson(*document, diagnostics);
  JsonObject from(diagnostics, document->root(), pointer);
  Element element;
  if constexpr (requires { element.id; }) {
    if (const auto id = from.id("id")) element.id = decltype(element.id)(*id);
  }
  readMembers(from, element);
  element.unknown = from.unknown();
  for (const auto& [name, value] : element.unknown) {
    if (hasMember(kept, name) || diagnostics.covers(pointer + pointerStep(name))) continue;
    diagnostics.add(Code::schema, translated("the member \"%1\" has no meaning here.", {name}), {},
                    pointer + pointerStep(name), document->root());
  }
  if (diagnostics.empty()) return element;
  Diagnostics problems = diagnostics.inOrder();
  for (Diagnostic& problem : problems) problem.line = problem.column = 0;  // those of no file
  return problems;
}

}  // namespace

template <class Element>
Expected<Element> withMembers(const Element& element, JsonValue changes, const MemberFilter& isMember,
                              const std::string& pointer) {
  const std::string before = elementJson(element);
  const auto own = JsonDocument::parse(before);
  if (!own) return own.error();
  return readElement<Element>(changedObject(own->root(), changes, isMember), element.unknown, pointer);
}

template <class Element>
Expected<Element> elementFrom(JsonValue members, const MemberFilter& isMember, const std::string& pointer) {
  return readElement<Element>(changedObject(std::nullopt, members, isMember), {}, pointer);
}

template Expected<Link> withMembers(const Link&, JsonValue, const MemberFilter&, const std::string&);
template Expected<Axis> withMembers(const Axis&, JsonValue, const MemberFilter&, const std::string&);
template Expected<TurningJoint> withMembers(const TurningJoint&, JsonValue, const MemberFilter&,
                                            const std::string&);
template Expected<GearMesh> withMembers(const GearMesh&, JsonValue, const MemberFilter&, const std::string&);
template Expected<Wheel> withMembers(const Wheel&, JsonValue, const MemberFilter&, const std::string&);
template Expected<ShiftElement> withMembers(const ShiftElement&, JsonValue, const MemberFilter&,
                                            const std::string&);
template Expected<ShiftState> withMembers(const ShiftState&, JsonValue, const MemberFilter&,
                                          const std::string&);
template Expected<Load> withMembers(const Load&, JsonValue, const MemberFilter&, const std::string&);
template Expected<Axis> elementFrom(JsonValue, const MemberFilter&, const std::string&);
template Expected<Wheel> elementFrom(JsonValue, const MemberFilter&, const std::string&);
template Expected<ShiftElement> elementFrom(JsonValue, const MemberFilter&, const std::string&);
template Expected<Load> elementFrom(JsonValue, const MemberFilter&, const std::string&);

Expected<Mechanism> withDocumentMembers(const Mechanism& mechanism, JsonValue changes,
                                        const MemberFilter& isMember) {
  const std::string before = writeMechanism(mechanism);
  const auto own = JsonDocument::parse(before);
  if (!own) return own.error();
  auto changed = readMechanism(changedObject(own->root(), changes, isMember));
  if (changed) return changed;
  Diagnostics problems = changed.error();
  for (Diagnostic& problem : problems) problem.line = problem.column = 0;  // those of no file
  return problems;
}

}  // namespace geargraph
