#pragma once

#include <span>
#include <string_view>

#include "core/foundations/base/id.h"

namespace geargraph {

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

constexpr int kMaxColorNumber = 1'000'000;  ///< of a link's colour

/// What a member holds, which decides how each format writes it.
enum class MemberValue {
  constant,        ///< the same in every document
  text,            ///< of any length
  shortText,       ///< at most kMaxNameLength characters
  id,              ///< of the object itself
  reference,       ///< the id of another element
  references,      ///< a list of ids
  flag,            ///< true or false
  teeth,           ///< a whole number from kMinTeeth to kMaxTeeth
  meshKind,        ///< meshKindName()
  hand,            ///< handName()
  jointKind,       ///< jointKindName(); turning is left out
  couplingKind,    ///< "brake" or "clutch"
  sharing,         ///< loadSharingName()
  number,          ///< exact; a fraction is a text
  triple,          ///< three numbers
  inertia,         ///< six numbers
  ends,            ///< two of number or null
  object,          ///< with members of its own
  objects,         ///< a list of such
  places,          ///< points on a sheet by the id of their link
  numbersOfLinks,  ///< whole numbers from 1 to kMaxColorNumber by the id of their link
  place,           ///< two JSON numbers
  position,        ///< three JSON numbers
  measure,         ///< a JSON number
};

/// What a number measures: its unit, and whether it is limited to +-kLargestLength.
enum class Measure {
  none,  ///< pure, without a limit
  number,
  coordinate,  ///< in the document's unit
  length,      ///< in the document's unit
  component,   ///< of a direction
  modules,
  angle,  ///< degrees
  turn,   ///< degrees, without a limit
  speed,  ///< rad/s, without a limit
  acceleration,
  density,
  mass,
  moment,  ///< of inertia
  torque,
  force,
};

/// "kg", "N m", ...; empty for pure numbers and for lengths in the document's unit.
[[nodiscard]] std::string_view unitOf(Measure measure);

/// The numbers that a member may have. Which sentence rejects others is the business of validate.h.
enum class NumberRange {
  any,
  positive,     ///< above 0
  notNegative,  ///< at least 0
  efficiency,   ///< above 0, at most 1
  fraction,     ///< from 0 to 1
  acuteAngle,   ///< at least 0, below 90
};

/// One member of the document's format. All that reads, writes, checks or explains members reads this.
struct MemberInfo {
  std::string_view name;
  MemberValue value = MemberValue::number;
  /// For the page of the format, the JSON Schema and Python; in Markdown.
  std::string_view meaning;
  bool isNeeded = false;
  /// What the document means without the member; empty where that goes without saying.
  std::string_view fallback = {};
  Measure measure = Measure::none;
  NumberRange range = NumberRange::any;
  ElementKind target = ElementKind::link;  ///< of a reference
  /// Of an object or a list of such: what they are.
  DocumentPart part = DocumentPart::document;
  /// What is missing without it, in the sentence of the reader; marked by toTranslate(). Only of needed
  /// members whose value does not say it.
  std::string_view expected = {};
  bool isAlwaysWritten = false;  ///< also where it is empty
  bool namesElement = false;     ///< diagnostics about the object name it by this reference
  /// The name of the attribute in graphs; empty: the member's.
  std::string_view attribute = {};
  bool isInGraphs = true;
  /// The member that it follows in tables and in lists of edits, if that is not the one before it in files.
  std::string_view listedAfter = {};
  int since = 1;  ///< version of the format
};

/// All members that objects of this kind may have, in the order of the format. Cost: O(1).
[[nodiscard]] std::span<const MemberInfo> membersOf(DocumentPart part);
/// The same in the order of tables and edits.
[[nodiscard]] std::span<const MemberInfo> listedMembersOf(DocumentPart part);
[[nodiscard]] std::span<const std::string_view> memberNames(DocumentPart part);
/// Null if such objects have no such member.
[[nodiscard]] const MemberInfo* memberOf(DocumentPart part, std::string_view name);
/// What such an object is called in the schema and in tables: "turningJoint".
[[nodiscard]] std::string_view objectName(DocumentPart part);
/// Where such objects are in a document, e.g. "links/shapes"; empty for the document itself.
[[nodiscard]] std::string_view partName(DocumentPart part);
/// Every kind of object, the document first, each before those inside it.
[[nodiscard]] std::span<const DocumentPart> documentParts();

}  // namespace geargraph
