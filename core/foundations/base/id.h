#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace geargraph {

/// An interned immutable text: an atom is a number, so ids are as cheap as an integer to copy, compare and
/// hash. Texts are never freed; a session has few.
///
/// Thread-safe: atoms may be made and compared from any thread.
class InternedString {
 public:
  InternedString() = default;  ///< the empty text
  explicit InternedString(std::string_view text);

  [[nodiscard]] const std::string& text() const;
  [[nodiscard]] bool empty() const { return m_number == 0; }
  /// The text's number, in the order of interning: ids of one list have numbers close together. 0 for the
  /// empty text.
  [[nodiscard]] std::size_t hash() const { return m_number; }

  friend bool operator==(InternedString a, InternedString b) { return a.m_number == b.m_number; }
  friend bool operator!=(InternedString a, InternedString b) { return a.m_number != b.m_number; }
  /// By text, so that the order does not depend on the run.
  friend bool operator<(InternedString a, InternedString b) {
    return a.m_number != b.m_number && a.text() < b.text();
  }

 private:
  std::uint32_t m_number = 0;
};

/// The stable identity of an element, unique within its list of the document. Tags prevent confusing the ids
/// of links and joints. Labels (the paper's numbers) are derived from positions and are not ids.
template <class Tag>
class Id {
 public:
  Id() = default;
  explicit Id(std::string_view text) : m_atom(text) {}
  explicit Id(InternedString atom) : m_atom(atom) {}

  [[nodiscard]] const std::string& text() const { return m_atom.text(); }
  [[nodiscard]] bool empty() const { return m_atom.empty(); }
  [[nodiscard]] InternedString atom() const { return m_atom; }

  friend bool operator==(Id a, Id b) { return a.m_atom == b.m_atom; }
  friend bool operator!=(Id a, Id b) { return a.m_atom != b.m_atom; }
  friend bool operator<(Id a, Id b) { return a.m_atom < b.m_atom; }

 private:
  InternedString m_atom;
};

using LinkId = Id<struct LinkTag>;
using AxisId = Id<struct AxisTag>;
using JointId = Id<struct JointTag>;  ///< turning joints
using MeshId = Id<struct MeshTag>;    ///< gear meshes
using WheelId = Id<struct WheelTag>;
using ShiftElementId = Id<struct CouplingTag>;
using LoadId = Id<struct LoadTag>;
using NoteId = Id<struct NoteTag>;

enum class ElementKind { link, axis, turningJoint, gearMesh, wheel, coupling, state, load, note };

/// The name of the document's list that holds elements of this kind, e.g. "turningJoints"; for a nested
/// list with its path, "view/notes".
[[nodiscard]] std::string_view listName(ElementKind kind);

/// The id of any element, for selection, highlighting and diagnostics.
struct ElementId {
  ElementKind kind = ElementKind::link;
  InternedString id;

  ElementId() = default;
  ElementId(ElementKind elementKind, InternedString elementId) : kind(elementKind), id(elementId) {}
  ElementId(LinkId link) : kind(ElementKind::link), id(link.atom()) {}                      // NOLINT
  ElementId(AxisId axis) : kind(ElementKind::axis), id(axis.atom()) {}                      // NOLINT
  ElementId(JointId joint) : kind(ElementKind::turningJoint), id(joint.atom()) {}           // NOLINT
  ElementId(MeshId mesh) : kind(ElementKind::gearMesh), id(mesh.atom()) {}                  // NOLINT
  ElementId(WheelId wheel) : kind(ElementKind::wheel), id(wheel.atom()) {}                  // NOLINT
  ElementId(ShiftElementId coupling) : kind(ElementKind::coupling), id(coupling.atom()) {}  // NOLINT
  ElementId(LoadId load) : kind(ElementKind::load), id(load.atom()) {}                      // NOLINT
  ElementId(NoteId note) : kind(ElementKind::note), id(note.atom()) {}                      // NOLINT

  friend bool operator==(ElementId a, ElementId b) { return a.kind == b.kind && a.id == b.id; }
  friend bool operator!=(ElementId a, ElementId b) { return !(a == b); }
  friend bool operator<(ElementId a, ElementId b) { return a.kind != b.kind ? a.kind < b.kind : a.id < b.id; }
};

}  // namespace geargraph

template <>
struct std::hash<geargraph::InternedString> {
  std::size_t operator()(geargraph::InternedString atom) const { return atom.hash(); }
};
template <class Tag>
struct std::hash<geargraph::Id<Tag>> {
  std::size_t operator()(geargraph::Id<Tag> id) const { return id.atom().hash(); }
};
template <>
struct std::hash<geargraph::ElementId> {
  std::size_t operator()(geargraph::ElementId element) const {
    return element.id.hash() * 31 + static_cast<std::size_t>(element.kind);
  }
};
