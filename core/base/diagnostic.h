#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/id.h"

namespace geargraph {

enum class Severity { error, warning, info };

/// What can be wrong with a document or a mechanism. Names and severities are those of the file format's
/// table: people's scripts match on them, so they never change.
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
  graphics,  ///< of the machine, not of a file: no OpenGL 3.3, or a driver that fails
};

/// The stable spelling of a code, e.g. "turning-loop".
[[nodiscard]] std::string_view codeName(Code code);
/// The severity that the file format's table gives the code.
[[nodiscard]] Severity severityOf(Code code);
[[nodiscard]] std::string_view severityName(Severity severity);

/// Every code, in the order of the table.
[[nodiscard]] const std::vector<Code>& allCodes();

/// One finding about a document: what is wrong, in a sentence that says what to do, and the culprits.
struct Diagnostic {
  Code code = Code::schema;
  std::string message;
  std::vector<ElementId> elements;  ///< the culprits, which every view lights up
  std::string pointer;              ///< JSON pointer into the file (schema errors), else empty
  int line = 0;                     ///< 1-based place in the file (syntax errors), else 0
  int column = 0;

  [[nodiscard]] Severity severity() const { return severityOf(code); }
  friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

using Diagnostics = std::vector<Diagnostic>;

[[nodiscard]] bool hasErrors(const Diagnostics& diagnostics);

}  // namespace geargraph
