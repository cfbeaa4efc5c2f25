#pragma once

#include <span>
#include <string_view>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

/// The objects of a document that have members of their own.
enum class DocumentPart {
  document,
  link,
  shape,
  axis,
  turningJoint,
  gearMesh,
  wheel,
  gearDefaults,
  input,
  coupling,
  state,
  load,
  balance,
  view,
  note,
  camera,
};

/// The names of all members that objects of this kind may have, in the order of the format.
[[nodiscard]] std::span<const std::string_view> memberNames(DocumentPart part);
/// Where such objects are in a document, e.g. "links/shapes"; empty for the document itself.
[[nodiscard]] std::string_view partName(DocumentPart part);

/// unknown-member: members of a document that this program does not know, one diagnostic for each name and
/// kind of object, with all elements that have it, and the nearest known name where it looks like a slip.
/// They are kept and change nothing. Cost: O(n), and O(known names) for each unknown one.
[[nodiscard]] Diagnostics unknownMemberDiagnostics(const Mechanism& mechanism);

/// The member that is surely meant by a common misspelling, e.g. "efficiency" by "efficency"; empty for other
/// names. The reader of documents rejects it in objects that may have that member.
[[nodiscard]] std::string_view misspelledMember(std::string_view name);

}  // namespace geargraph::inline model
