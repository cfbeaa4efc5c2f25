#include <algorithm>
#include <set>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/utf8.h"
#include "core/mechanism/document_format/element_reader.h"
#include "core/mechanism/document_format/json_object.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/view_reader.h"
#include "core/mechanism/model/fields.h"
#include "core/mechanism/model/validate.h"

namespace geargraph {
namespace {

/// Finds values by their JSON pointer; the elements of top-level lists in constant time.
class Places {
 public:
  explicit Places(JsonValue root) {
    root.forEachMember([&](JsonValue key, JsonValue value) {
      Member& member = m_members.try_emplace(key.string(), Member{value, {}}).first->second;
      if (value.is(JsonKind::array)) {
        value.forEachElement([&](JsonValue element, std::size_t) { member.elements.push_back(element); });
      }
    });
  }

  /// The value at a pointer of the form /list/position/member/..., or the nearest one around it.
  [[nodiscard]] JsonValue at(std::string_view pointer, JsonValue root) const {
    JsonValue value = root;
    const auto member = m_members.find(nextStep(pointer));
    if (member == m_members.end()) return value;
    value = member->second.value;
    for (bool first = true; !pointer.empty(); first = false) {
      const std::string step = nextStep(pointer);
      std::optional<JsonValue> inner;
      if (value.is(JsonKind::object)) inner = value.member(step);
      if (value.is(JsonKind::array)) {
        const std::size_t position = std::stoul(step);
        inner = first && position < member->second.elements.size() ? member->second.elements[position]
                                                                   : value.element(position);
      }
      if (!inner) return value;
      value = *inner;
    }
    return value;
  }

 private:
  struct Member {
    JsonValue value;
    std::vector<JsonValue> elements;
  };

  static std::string nextStep(std::string_view& pointer) {
    const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
    std::string step(pointer.substr(1, end - 1));
    pointer.remove_prefix(end);
    return step;
  }

  std::map<std::string, Member, std::less<>> m_members;
};

/// Reads the members of a document whose JSON is sound.
class MechanismReader {
 public:
  explicit MechanismReader(const JsonDocument& document)
      : m_document(document), m_root(document.root()), m_diagnostics(document) {}

  Expected<Mechanism> run() {
    if (!readHeader()) return m_diagnostics.inOrder();
    checkJson(m_document, m_diagnostics);
    JsonObject root(m_diagnostics, m_root, "");
    readRoot(root);
    m_mechanism.unknown = root.unknown();
    addSemanticDiagnostics();
    if (!m_diagnostics.empty()) return m_diagnostics.inOrder();
    return std::move(m_mechanism);
  }

 private:
  bool readHeader() {
    if (!m_root.is(JsonKind::object)) return notThisFormat(m_root);
    const auto format = m_root.member("format");
    if (!format) return notThisFormat(m_root);
    if (!format->is(JsonKind::string) || !format->equals("geargraph")) return notThisFormat(*format);
    const auto version = m_root.member("version");
    if (!version || !version->is(JsonKind::number)) return true;  // readRoot() says what is wrong
    const auto number = Rational::fromText(version->slice());
    if (!number || !number->isInteger() || *number <= kFileVersion) return true;
    m_diagnostics.add(
        Code::version,
        translated("The file has version %1, but this program reads version %2: open it with a newer "
                   "GearGraph.",
                   {version->slice(), std::to_string(kFileVersion)}),
        {}, "/version", *version);
    return false;
  }

  bool notThisFormat(JsonValue at) {
    m_diagnostics.add(
        Code::format,
        translated("This is not a GearGraph document: the member \"format\" has to be \"geargraph\"."), {},
        "/format", at);
    return false;
  }

  void readRoot(JsonObject& root) {
    (void)root.member("format");
    (void)root.requiredWhole("version", 1, kFileVersion);
    forEachField<Mechanism>([&](const auto& field) { read(root, field.info(), m_mechanism.*field.member); });
    requireLists(root);
  }

  /// The lists that others need: joints where links move, axes where there are joints.
  void requireLists(JsonObject& root) {
    const auto require = [&]<class List>(List Mechanism::*list) {
      forEachField<Mechanism>([&](const auto& field) {
        if constexpr (std::is_same_v<decltype(field.member), decltype(list)>) {
          using Element = typename ElementOfList<List>::Type;
          if (!root.required(field.info().name, field.info().expected))
            m_unread.insert(ElementId(Element().id).kind);
        }
      });
    };
    if (m_mechanism.links.size() > 1) require(&Mechanism::turningJoints);
    if (!m_mechanism.turningJoints.empty()) require(&Mechanism::axes);
  }

  // The members of the document, by the type of their value.

  template <class Value>
  requires requires(JsonObject& from, const MemberInfo& info, Value& value) { readValue(from, info, value); }
  void read(JsonObject& root, const MemberInfo& info, Value& value) { readValue(root, info, value); }

  template <class List>
  requires DescribedList<List>
  void read(JsonObject& root, const MemberInfo& info, List& list) {
    const auto value = info.isNeeded ? root.required(info.name, info.expected) : root.member(info.name);
    if constexpr (kNeedsId<typename ElementOfList<List>::Type>) {
      readList(value, info, list);
    } else {
      if (value) readObjects(*value, info, list);
    }
    if constexpr (std::is_same_v<List, ByCoupling<ShiftElement>>) nameLinks();
  }
  template <class Element>
  void read(JsonObject& root, const MemberInfo& info, std::optional<std::vector<Element>>& list) {
    if (const auto value = root.member(info.name)) readObjects(*value, info, list.emplace());
  }
  void read(JsonObject& root, const MemberInfo& info, std::optional<GearDefaults>& defaults) {
    const auto value = root.member(info.name);
    if (!value) return;
    JsonObject from(m_diagnostics, *value, pointerStep(info.name));
    readMembers(from, defaults.emplace());
    defaults->unknown = from.unknown();
  }
  void read(JsonObject& root, const MemberInfo& info, View& view) {
    if (const auto value = root.member(info.name)) view = readView(m_diagnostics, info, *value);
  }

  /// Couplings that could not be read hold the ground, so that no more diagnostics follow.
  void nameLinks() {
    for (ShiftElement& coupling : m_mechanism.couplings) {
      const bool isUnread = coupling.links.empty() && coupling.kind == ShiftElementKind::brake;
      if (isUnread && !m_mechanism.links.empty()) coupling.links = {m_mechanism.links.front().id};
    }
  }

  /// Reads a list of objects that need no id.
  template <class Element>
  void readObjects(JsonValue list, const MemberInfo& info, std::vector<Element>& elements) {
    forEachObject(list, pointerStep(info.name), [&](JsonObject& from) {
      Element& element = elements.emplace_back();
      if constexpr (requires { element.id; }) {
        if (const auto id = from.id("id")) element.id = decltype(element.id)(*id);
      }
      readMembers(from, element);
      element.unknown = from.unknown();
    });
  }

  /// Calls read(object) for each element of a list; a value that is no list is a diagnostic.
  template <class Read>
  bool forEachObject(JsonValue list, const std::string& pointer, Read read) {
    if (m_diagnostics.covers(pointer)) return false;  // too long: said already
    if (!list.is(JsonKind::array)) {
      m_diagnostics.add(Code::schema, translated("expected a list."), {}, pointer, list);
      return false;
    }
    list.forEachElement([&](JsonValue value, std::size_t position) {
      JsonObject object(m_diagnostics, value, pointer + pointerStep(position));
      read(object);
    });
    return true;
  }

  /// Reads a list of elements with ids. Each element of the file gives one here, however broken, so that
  /// positions in diagnostics stay those of the file.
  template <class Element>
  void readList(std::optional<JsonValue> list, const MemberInfo& info, std::vector<Element>& elements) {
    const ElementKind kind = ElementId(Element().id).kind;
    const std::string pointer = pointerStep(info.name);
    if (!list) {
      if (m_diagnostics.covers(pointer)) m_unread.insert(kind);
      return;
    }
    const bool isRead = forEachObject(*list, pointer, [&](JsonObject& from) {
      Element element;
      const InternedString id = from.requiredId("id");
      if (id.empty()) {
        m_unread.insert(kind);
      } else {
        element.id = decltype(element.id)(id);
        from.blame(element.id);
      }
      readMembers(from, element);
      element.unknown = from.unknown();
      elements.push_back(std::move(element));
    });
    if (!isRead) m_unread.insert(kind);
  }

  /// What is wrong with the elements together, without what only follows from a diagnostic there is already.
  void addSemanticDiagnostics() {
    const Diagnostics found = wellFormedDiagnostics(m_mechanism);
    if (found.empty()) return;
    const Places places(m_root);
    for (const Diagnostic& diagnostic : found) {
      if (m_diagnostics.covers(diagnostic.pointer)) continue;
      const bool toUnread = diagnostic.code == Code::unknownId && !diagnostic.elements.empty() &&
                            m_unread.contains(diagnostic.elements.back().kind);
      if (toUnread) continue;
      m_diagnostics.add(diagnostic.code, diagnostic.message, diagnostic.elements, diagnostic.pointer,
                        places.at(diagnostic.pointer, m_root));
    }
  }

  const JsonDocument& m_document;
  JsonValue m_root;
  JsonDiagnostics m_diagnostics;
  Mechanism m_mechanism;
  std::set<ElementKind> m_unread;  ///< lists with an id that could not be read
};

/// False for pictures, archives and programs, and for texts in UTF-16: their first bytes are no characters in
/// UTF-8, or control characters.
bool beginsAsText(std::string_view bytes) {
  constexpr std::size_t kSignature = 4;
  for (std::size_t at = 0; at < std::min(bytes.size(), kSignature);) {
    const std::size_t length = utf8Length(bytes, at);
    const bool isBlank = std::string_view("\t\n\r").find(bytes[at]) != std::string_view::npos;
    if (length == 0 || (static_cast<unsigned char>(bytes[at]) < 0x20 && !isBlank)) return false;
    at += length;
  }
  return true;
}

Diagnostic noText() {
  Diagnostic diagnostic;
  diagnostic.code = Code::syntax;
  diagnostic.line = diagnostic.column = 1;
  diagnostic.message = translated(
      "This is no GearGraph document: the file is not text in UTF-8, but a picture, an archive or the like, "
      "or "
      "damaged.");
  return diagnostic;
}

}  // namespace

Expected<Mechanism> readMechanism(std::string_view bytes) {
  if (bytes.size() > kLargestFile) {
    return Diagnostic{
        Code::schema,
        translated("The file has %1 bytes; at most 64 MiB are read.", {std::to_string(bytes.size())}),
        {},
        {},
        0,
        0};
  }
  const auto document = JsonDocument::parse(bytes);
  if (!document) return beginsAsText(bytes) ? document.error() : Diagnostics{noText()};
  return MechanismReader(*document).run();
}

}  // namespace geargraph
