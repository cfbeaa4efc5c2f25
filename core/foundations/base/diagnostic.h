#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/id.h"

namespace geargraph {

enum class Severity { error, warning, info };

/// The codes of diagnostics. Names and severities are those of the table in resources/schema/README.md; they
/// never change, because users' scripts depend on them.
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
  stateIdle,
  freewheelDirection,
  locked,
  deadJoint,
  idleJoint,
  noMeshes,
  piMixed,
  slidesNotCovered,  ///< of an analysis that does not know sliding joints
  invalidInputs,
  splitAxis,
  mergedAxes,
  assembly,
  undercut,
  interference,
  standIn,
  symbolicSkipped,
  // of statics
  noLoad,
  unitLoad,
  unbalanced,
  loadOnBalance,
  staticallyIndeterminate,
  selfLocking,
  recirculation,
  noMotion,
  noEfficiency,
  deadLoad,
  unknownUnit,
  patternLimit,
  graphics,  ///< of the computer, not of a file: no OpenGL 3.3, or a failing driver
  // of what a document has beside the mechanism
  unknownMember,
  missingFile,
  shownOnly,
};

/// The stable spelling of a code, e.g. "turning-loop".
[[nodiscard]] std::string_view codeName(Code code);
/// The severity that this table gives the code.
[[nodiscard]] Severity severityOf(Code code);
[[nodiscard]] std::string_view severityName(Severity severity);

/// Every code, in the order of the table.
[[nodiscard]] const std::vector<Code>& allCodes();

/// The sub-code, which distinguishes diagnostics with the same code; as stable as the code. `none` for a code
/// with a single meaning.
enum class Detail {
  none,
  // turning-loop
  redundantBearing,  ///< all joints of the loop turn about one axis
  turningCycle,      ///< the loop leads over several axes
  couplingLinkage,   ///< an engaged coupling closes a loop over axes of four directions or more
  clutchAxes,        ///< a clutch between links that do not turn about one line against each other
  // redundant-mesh
  equalPlanets,  ///< meshes of equal planets, which share the load: a note
  // pitch-geometry
  skewAxes,
  coincidentAxes,              ///< the two axes of a mesh are one line in the reference pose
  pitchPointOffPlane,          ///< it is not in the plane of the two axes
  pitchPointOffPerpendicular,  ///< of skew axes: it is not on their common perpendicular, between them
  kindAgainstAxes,             ///< `kind` contradicts the position of the axes
  noBevelPair,                 ///< an edit of bevels, on another pair
  // teeth-geometry
  kindAgainstSides,   ///< `kind` contradicts the sides of the axes on which the pitch point lies
  teethAgainstRadii,  ///< the ratio of the teeth is not that of the pitch radii
  equalInternalTeeth,
  helixAgainstTeeth,  ///< the helix angle does not fit the pair, or another pair of the same wheel
  wormTeeth,          ///< numbers of starts and teeth that no worm and wheel have
  beltGeometry,       ///< no strand can run round the pulleys of a belt, or its ends say different things
  pinnedWheel,        ///< an edit that would have to change pinned gears or axes
  pinnedModule,
  pinnedAxis,
  // assembly
  unequalPlanets,  ///< planets that are drawn equal have to differ
  // interference
  noToothForm,      ///< no solid can be made of the gear
  pointedTeeth,     ///< tips lowered to keep a top land
  contactRatio,     ///< too few pairs of teeth in contact
  faceTooWide,      ///< a bevel's face over a third of the cone distance
  tipInterference,  ///< tips of pinion and ring collide outside of the mesh
  ringTipsLowered,  ///< tips of a ring shortened to clear the pinion's fillets
  planetsOverlap,   ///< tips of neighbouring planets
  wheelsOverlap,    ///< gears that do not mesh with each other
  bodiesOverlap,    ///< shafts, arms and carriers for which no clear route was found
  motionCollision,  ///< links that collide while the mechanism moves (Diagnostic::time)
};

/// The stable spelling of a detail after its code, e.g. "interference/wheels-overlap"; empty for none.
[[nodiscard]] std::string_view detailName(Detail detail);
/// The code of a detail. @pre it is not none
[[nodiscard]] Code codeOf(Detail detail);
/// The severity of a diagnostic with this detail, that of its code unless the table says otherwise. @pre it
/// is not none
[[nodiscard]] Severity severityOf(Detail detail);
/// Every detail but none, in the order of the enumeration.
[[nodiscard]] const std::vector<Detail>& allDetails();

/// A diagnostic about a document: an explanation that says what to do, and the elements concerned.
struct Diagnostic {
  Code code = Code::schema;
  std::string message;
  std::vector<ElementId> elements;  ///< the elements to blame, which every view highlights
  std::string pointer;              ///< JSON pointer into the file (schema errors), else empty
  int line = 0;                     ///< 1-based position in the file (syntax errors), else 0
  int column = 0;
  Detail detail = Detail::none;     ///< one of `code`
  std::optional<double> time = {};  ///< time in the motion at which it occurs, s (collisions in motion)

  [[nodiscard]] Severity severity() const {
    return detail == Detail::none ? severityOf(code) : severityOf(detail);
  }
  friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

using Diagnostics = std::vector<Diagnostic>;

/// Appends `more` to `all`.
inline void append(Diagnostics& all, const Diagnostics& more) {
  all.insert(all.end(), more.begin(), more.end());
}

[[nodiscard]] bool hasErrors(const Diagnostics& diagnostics);

/// Errors, then warnings, then notes, each in their order.
void sortBySeverity(Diagnostics& diagnostics);

}  // namespace geargraph
