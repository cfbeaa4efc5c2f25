#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/id.h"

namespace geargraph::inline base {

enum class Severity { error, warning, info };

/// What can be wrong with a document or a mechanism. Names and severities are those of the table in
/// resources/schema/README.md: people's scripts match on them, so they never change.
enum class Code {
  syntax,
  format,
  version,
  schema,
  duplicateId,
  unknownId,
  selfJoint,
  disconnected,
  turningLoop,
  coaxialMesh,
  noTransferVertex,
  pitchPointOnAxis,
  pitchGeometry,
  teethGeometry,
  redundantMesh,
  redundantCoupling,
  stateLocked,
  stateFree,
  locked,
  deadJoint,
  idleJoint,
  noMeshes,
  invalidInputs,
  splitAxis,
  mergedAxes,
  assembly,
  undercut,
  interference,
  symbolicSkipped,
  // of statics
  noLoad,
  unitLoad,
  unbalanced,
  staticallyIndeterminate,
  selfLocking,
  recirculation,
  noMotion,
  noEfficiency,
  deadLoad,
  unknownUnit,
  patternLimit,
  graphics,  ///< of the machine, not of a file: no OpenGL 3.3, or a driver that fails
};

/// The stable spelling of a code, e.g. "turning-loop".
[[nodiscard]] std::string_view codeName(Code code);
/// The severity that this table gives the code.
[[nodiscard]] Severity severityOf(Code code);
[[nodiscard]] std::string_view severityName(Severity severity);

/// Every code, in the order of the table.
[[nodiscard]] const std::vector<Code>& allCodes();

/// Which of the findings that share a code: a sub-code, as stable as the code. A code that stands for one
/// finding has none.
enum class Detail {
  none,
  // turning-loop
  redundantBearing,  ///< all joints of the loop turn about one axis
  turningCycle,      ///< the loop leads over several axes
  couplingLinkage,   ///< an engaged coupling closes a loop over axes of four directions or more
  // pitch-geometry
  skewAxes,
  coincidentAxes,      ///< the two axes of a mesh are one line in the reference pose
  pitchPointOffPlane,  ///< it is not in the plane of the two axes
  kindAgainstAxes,     ///< `kind` contradicts the position of the axes
  noBevelPair,         ///< an edit of bevels, on another pair
  // teeth-geometry
  kindAgainstSides,   ///< `kind` contradicts the sides of the axes on which the pitch point lies
  teethAgainstRadii,  ///< the ratio of the teeth is not that of the pitch radii
  equalInternalTeeth,
  pinnedWheel,  ///< an edit that only pinned gears or axes could follow
  pinnedModule,
  pinnedAxis,
  // interference
  noToothForm,      ///< no solid can be made of the gear
  pointedTeeth,     ///< tips lowered to keep a land
  contactRatio,     ///< too few pairs of teeth in contact
  faceTooWide,      ///< a bevel's face over a third of the cone distance
  tipInterference,  ///< tips of pinion and ring collide outside of the mesh
  ringTipsLowered,  ///< tips of a ring shortened to clear the pinion's fillets
  planetsOverlap,   ///< tips of neighbouring planets
  wheelsOverlap,    ///< gears that do not mesh with each other
  bodiesOverlap,    ///< shafts, arms and carriers for which no clear route was found
  motionCollision,  ///< links that meet while the mechanism moves (Diagnostic::time)
};

/// The stable spelling of a detail behind its code, e.g. "interference/wheels-overlap"; empty for none.
[[nodiscard]] std::string_view detailName(Detail detail);
/// The code of which it is a case. @pre it is not none
[[nodiscard]] Code codeOf(Detail detail);
/// Every detail but none, in the order of the enumeration.
[[nodiscard]] const std::vector<Detail>& allDetails();

/// One finding about a document: what is wrong, in a sentence that says what to do, and the culprits.
struct Diagnostic {
  Code code = Code::schema;
  std::string message;
  std::vector<ElementId> elements;  ///< the culprits, which every view lights up
  std::string pointer;              ///< JSON pointer into the file (schema errors), else empty
  int line = 0;                     ///< 1-based place in the file (syntax errors), else 0
  int column = 0;
  Detail detail = Detail::none;     ///< one of `code`
  std::optional<double> time = {};  ///< s of the motion at which it shows (collisions in motion)

  [[nodiscard]] Severity severity() const { return severityOf(code); }
  friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

using Diagnostics = std::vector<Diagnostic>;

/// Adds `more` behind `all`.
inline void append(Diagnostics& all, const Diagnostics& more) {
  all.insert(all.end(), more.begin(), more.end());
}

[[nodiscard]] bool hasErrors(const Diagnostics& diagnostics);

}  // namespace geargraph::inline base
