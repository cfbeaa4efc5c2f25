#include <algorithm>
#include <set>

#include "core/foundations/base/words.h"
#include "core/foundations/files/utf8.h"
#include "core/mechanism/document_format/element_reader.h"
#include "core/mechanism/document_format/json_object.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/mechanism/document_format/view_reader.h"
#include "core/mechanism/model/validate.h"

namespace geargraph::inline document_format {
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
    m_mechanism.name = root.shortText("name").value_or("");
    m_mechanism.notes = root.text("notes").value_or("");
    m_mechanism.unit = root.shortText("unit").value_or(m_mechanism.unit);
    readStructure(root);
    readGears(root);
    readInputs(root);
    readShifting(root);
    readLoads(root);
    m_mechanism.sharing = sharingOf(root);
    m_mechanism.driveTorque = root.number("driveTorque");
    m_mechanism.density = root.number("density");
    m_mechanism.gravity = root.triple("gravity");
    if (const auto view = root.member("view")) m_mechanism.view = readView(m_diagnostics, *view);
  }

  void readStructure(JsonObject& root) {
    readList(root.required("links", toTranslate("a list of links, the ground first")), ElementKind::link,
             m_mechanism.links);
    const auto joints =
        m_mechanism.links.size() > 1
            ? root.required("turningJoints", toTranslate("a list of turning joints that tie the links"))
            : root.member("turningJoints");
    readList(joints, ElementKind::turningJoint, m_mechanism.turningJoints);
    const auto axes =
        m_mechanism.turningJoints.empty()
            ? root.member("axes")
            : root.required("axes", toTranslate("a list of the axes that the turning joints name"));
    readList(axes, ElementKind::axis, m_mechanism.axes);
  }

  void readGears(JsonObject& root) {
    readList(root.member("gearMeshes"), ElementKind::gearMesh, m_mechanism.gearMeshes);
    readList(root.member("wheels"), ElementKind::wheel, m_mechanism.wheels);
    if (const auto value = root.member("gearDefaults")) {
      JsonObject from(m_diagnostics, *value, "/gearDefaults");
      GearDefaults& defaults = m_mechanism.gearDefaults.emplace();
      readMembers(from, defaults);
      defaults.unknown = from.unknown();
    }
  }

  static std::optional<LoadSharing> sharingOf(JsonObject& from) {
    const auto value = from.member("sharing");
    if (!value) return std::nullopt;
    for (const LoadSharing sharing : {LoadSharing::none, LoadSharing::stiffness}) {
      if (value->is(JsonKind::string) && value->equals(loadSharingName(sharing))) return sharing;
    }
    from.wrong("sharing", *value, toTranslate("\"none\" or \"stiffness\""));
    return std::nullopt;
  }

  void readInputs(JsonObject& root) {
    const auto value = root.member("inputs");
    if (!value) return;
    std::vector<Input>& inputs = m_mechanism.inputs.emplace();
    forEachObject(*value, "/inputs", [&](JsonObject& from) {
      Input& input = inputs.emplace_back();
      input.joint = JointId(from.requiredId("joint"));
      if (!input.joint.empty()) from.blame(input.joint);
      (void)from.required("speed", toTranslate("a speed in rad/s"));
      input.speed = from.number("speed").value_or(Number());
      input.unknown = from.unknown();
    });
  }

  void readShifting(JsonObject& root) {
    readList(root.member("couplings"), ElementKind::coupling, m_mechanism.couplings);
    for (Coupling& coupling : m_mechanism.couplings) {
      const bool isUnread = coupling.links.empty() && coupling.kind == CouplingKind::brake;
      if (isUnread && !m_mechanism.links.empty())
        coupling.links = {m_mechanism.links.front().id};  // no more diagnostics
    }
    for (const Atom id : root.ids("engaged").value_or(std::vector<Atom>{}))
      m_mechanism.engaged.emplace_back(id);
    const auto states = root.member("states");
    if (!states) return;
    forEachObject(*states, "/states", [&](JsonObject& from) {
      ShiftState& state = m_mechanism.states.emplace_back();
      readMembers(from, state);
      state.unknown = from.unknown();
    });
  }

  void readLoads(JsonObject& root) {
    if (const auto loads = root.member("loads")) {
      forEachObject(*loads, "/loads", [&](JsonObject& from) {
        Load& load = m_mechanism.loads.emplace_back();
        if (const auto id = from.id("id")) load.id = LoadId(*id);
        readMembers(from, load);
        load.unknown = from.unknown();
      });
    }
    const auto value = root.member("balances");
    if (!value) return;
    std::vector<Balance>& balances = m_mechanism.balances.emplace();
    forEachObject(*value, "/balances", [&](JsonObject& from) {
      Balance& balance = balances.emplace_back();
      readMembers(from, balance);
      balance.unknown = from.unknown();
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
  void readList(std::optional<JsonValue> list, ElementKind kind, std::vector<Element>& elements) {
    const std::string pointer = pointerStep(listName(kind));
    if (!list) {
      if (m_diagnostics.covers(pointer)) m_unread.insert(kind);
      return;
    }
    const bool isRead = forEachObject(*list, pointer, [&](JsonObject& from) {
      Element element;
      const Atom id = from.requiredId("id");
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

}  // namespace geargraph::inline document_format
