#include "core/base/diagnostic.h"

#include <algorithm>
#include <array>

#include "core/base/contract.h"

namespace geargraph {
namespace {

struct CodeEntry {
  Code code;
  std::string_view name;
  Severity severity;
};

// In the order of the enumeration, which is the order of the file format's table.
constexpr std::array kCodes = {
    CodeEntry{Code::syntax, "syntax", Severity::error},
    CodeEntry{Code::format, "format", Severity::error},
    CodeEntry{Code::version, "version", Severity::error},
    CodeEntry{Code::schema, "schema", Severity::error},
    CodeEntry{Code::duplicateId, "duplicate-id", Severity::error},
    CodeEntry{Code::unknownId, "unknown-id", Severity::error},
    CodeEntry{Code::selfJoint, "self-joint", Severity::error},
    CodeEntry{Code::disconnected, "disconnected", Severity::error},
    CodeEntry{Code::turningLoop, "turning-loop", Severity::error},
    CodeEntry{Code::coaxialMesh, "coaxial-mesh", Severity::error},
    CodeEntry{Code::noTransferVertex, "no-transfer-vertex", Severity::error},
    CodeEntry{Code::pitchPointOnAxis, "pitch-point-on-axis", Severity::error},
    CodeEntry{Code::pitchGeometry, "pitch-geometry", Severity::error},
    CodeEntry{Code::teethGeometry, "teeth-geometry", Severity::error},
    CodeEntry{Code::redundantMesh, "redundant-mesh", Severity::warning},
    CodeEntry{Code::stateLocked, "state-locked", Severity::warning},
    CodeEntry{Code::stateFree, "state-free", Severity::warning},
    CodeEntry{Code::locked, "locked", Severity::warning},
    CodeEntry{Code::deadJoint, "dead-joint", Severity::warning},
    CodeEntry{Code::idleJoint, "idle-joint", Severity::info},
    CodeEntry{Code::noMeshes, "no-meshes", Severity::info},
    CodeEntry{Code::invalidInputs, "invalid-inputs", Severity::error},
    CodeEntry{Code::splitAxis, "split-axis", Severity::warning},
    CodeEntry{Code::mergedAxes, "merged-axes", Severity::info},
    CodeEntry{Code::assembly, "assembly", Severity::warning},
    CodeEntry{Code::undercut, "undercut", Severity::warning},
    CodeEntry{Code::interference, "interference", Severity::warning},
    CodeEntry{Code::symbolicSkipped, "symbolic-skipped", Severity::info},
    CodeEntry{Code::graphics, "graphics", Severity::error},
};

const CodeEntry& entryOf(Code code) {
  const CodeEntry& entry = kCodes.at(static_cast<std::size_t>(code));
  GEARGRAPH_REQUIRE(entry.code == code);
  return entry;
}

}  // namespace

std::string_view codeName(Code code) {
  return entryOf(code).name;
}

Severity severityOf(Code code) {
  return entryOf(code).severity;
}

std::string_view severityName(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::warning:
      return "warning";
    case Severity::info:
      return "info";
  }
  GEARGRAPH_REQUIRE(false);
}

const std::vector<Code>& allCodes() {
  static const std::vector<Code> codes = [] {
    std::vector<Code> all;
    for (const CodeEntry& entry : kCodes) all.push_back(entry.code);
    return all;
  }();
  return codes;
}

bool hasErrors(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity() == Severity::error; });
}

}  // namespace geargraph
