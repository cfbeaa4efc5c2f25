#include "core/foundations/base/diagnostic.h"

#include <algorithm>
#include <array>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

struct CodeEntry {
  Code code;
  std::string_view name;
  Severity severity;
};

// In the order of the enumeration, which is that of the table in resources/schema/README.md.
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
    CodeEntry{Code::redundantCoupling, "redundant-coupling", Severity::info},
    CodeEntry{Code::stateLocked, "state-locked", Severity::warning},
    CodeEntry{Code::stateFree, "state-free", Severity::warning},
    CodeEntry{Code::stateIdle, "state-idle", Severity::info},
    CodeEntry{Code::freewheelDirection, "freewheel-direction", Severity::error},
    CodeEntry{Code::locked, "locked", Severity::warning},
    CodeEntry{Code::deadJoint, "dead-joint", Severity::warning},
    CodeEntry{Code::idleJoint, "idle-joint", Severity::info},
    CodeEntry{Code::noMeshes, "no-meshes", Severity::info},
    CodeEntry{Code::piMixed, "pi-mixed", Severity::error},
    CodeEntry{Code::slidesNotCovered, "slides-not-covered", Severity::error},
    CodeEntry{Code::invalidInputs, "invalid-inputs", Severity::error},
    CodeEntry{Code::splitAxis, "split-axis", Severity::warning},
    CodeEntry{Code::mergedAxes, "merged-axes", Severity::info},
    CodeEntry{Code::assembly, "assembly", Severity::warning},
    CodeEntry{Code::undercut, "undercut", Severity::warning},
    CodeEntry{Code::interference, "interference", Severity::warning},
    CodeEntry{Code::standIn, "stand-in", Severity::info},
    CodeEntry{Code::symbolicSkipped, "symbolic-skipped", Severity::info},
    CodeEntry{Code::noLoad, "no-load", Severity::info},
    CodeEntry{Code::unitLoad, "unit-load", Severity::info},
    CodeEntry{Code::unbalanced, "unbalanced", Severity::error},
    CodeEntry{Code::loadOnBalance, "load-on-balance", Severity::warning},
    CodeEntry{Code::staticallyIndeterminate, "statically-indeterminate", Severity::warning},
    CodeEntry{Code::selfLocking, "self-locking", Severity::error},
    CodeEntry{Code::recirculation, "recirculation", Severity::info},
    CodeEntry{Code::noMotion, "no-motion", Severity::info},
    CodeEntry{Code::noEfficiency, "no-efficiency", Severity::info},
    CodeEntry{Code::deadLoad, "dead-load", Severity::info},
    CodeEntry{Code::unknownUnit, "unknown-unit", Severity::info},
    CodeEntry{Code::patternLimit, "pattern-limit", Severity::warning},
    CodeEntry{Code::graphics, "graphics", Severity::error},
    CodeEntry{Code::unknownMember, "unknown-member", Severity::info},
    CodeEntry{Code::missingFile, "missing-file", Severity::warning},
    CodeEntry{Code::shownOnly, "shown-only", Severity::info},
};

struct DetailEntry {
  Detail detail;
  Code code;
  std::string_view name;
};

// In the order of the enumeration.
constexpr std::array kDetails = {
    DetailEntry{Detail::redundantBearing, Code::turningLoop, "turning-loop/redundant-bearing"},
    DetailEntry{Detail::turningCycle, Code::turningLoop, "turning-loop/cycle"},
    DetailEntry{Detail::couplingLinkage, Code::turningLoop, "turning-loop/coupling-linkage"},
    DetailEntry{Detail::clutchAxes, Code::turningLoop, "turning-loop/clutch-axes"},
    DetailEntry{Detail::equalPlanets, Code::redundantMesh, "redundant-mesh/equal-planets"},
    DetailEntry{Detail::skewAxes, Code::pitchGeometry, "pitch-geometry/skew-axes"},
    DetailEntry{Detail::coincidentAxes, Code::pitchGeometry, "pitch-geometry/coincident-axes"},
    DetailEntry{Detail::pitchPointOffPlane, Code::pitchGeometry, "pitch-geometry/off-plane"},
    DetailEntry{Detail::pitchPointOffPerpendicular, Code::pitchGeometry, "pitch-geometry/off-perpendicular"},
    DetailEntry{Detail::kindAgainstAxes, Code::pitchGeometry, "pitch-geometry/kind"},
    DetailEntry{Detail::noBevelPair, Code::pitchGeometry, "pitch-geometry/no-bevel-pair"},
    DetailEntry{Detail::kindAgainstSides, Code::teethGeometry, "teeth-geometry/kind"},
    DetailEntry{Detail::teethAgainstRadii, Code::teethGeometry, "teeth-geometry/ratio"},
    DetailEntry{Detail::equalInternalTeeth, Code::teethGeometry, "teeth-geometry/equal-internal-teeth"},
    DetailEntry{Detail::helixAgainstTeeth, Code::teethGeometry, "teeth-geometry/helix"},
    DetailEntry{Detail::wormTeeth, Code::teethGeometry, "teeth-geometry/worm"},
    DetailEntry{Detail::beltGeometry, Code::teethGeometry, "teeth-geometry/belt"},
    DetailEntry{Detail::pinnedWheel, Code::teethGeometry, "teeth-geometry/pinned-wheel"},
    DetailEntry{Detail::pinnedModule, Code::teethGeometry, "teeth-geometry/pinned-module"},
    DetailEntry{Detail::pinnedAxis, Code::teethGeometry, "teeth-geometry/pinned-axis"},
    DetailEntry{Detail::unequalPlanets, Code::assembly, "assembly/unequal-planets"},
    DetailEntry{Detail::noToothForm, Code::interference, "interference/no-tooth-form"},
    DetailEntry{Detail::pointedTeeth, Code::interference, "interference/pointed-teeth"},
    DetailEntry{Detail::contactRatio, Code::interference, "interference/contact-ratio"},
    DetailEntry{Detail::faceTooWide, Code::interference, "interference/face-too-wide"},
    DetailEntry{Detail::tipInterference, Code::interference, "interference/tip-interference"},
    DetailEntry{Detail::ringTipsLowered, Code::interference, "interference/ring-tips-lowered"},
    DetailEntry{Detail::planetsOverlap, Code::interference, "interference/planets-overlap"},
    DetailEntry{Detail::wheelsOverlap, Code::interference, "interference/wheels-overlap"},
    DetailEntry{Detail::bodiesOverlap, Code::interference, "interference/bodies-overlap"},
    DetailEntry{Detail::motionCollision, Code::interference, "interference/motion-collision"},
};

const DetailEntry& entryOf(Detail detail) {
  GEARGRAPH_REQUIRE(detail != Detail::none);
  const DetailEntry& entry = kDetails.at(static_cast<std::size_t>(detail) - 1);
  GEARGRAPH_REQUIRE(entry.detail == detail);
  return entry;
}

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

std::string_view detailName(Detail detail) {
  return detail == Detail::none ? std::string_view() : entryOf(detail).name;
}

Code codeOf(Detail detail) {
  return entryOf(detail).code;
}

const std::vector<Detail>& allDetails() {
  static const std::vector<Detail> details = [] {
    std::vector<Detail> all;
    for (const DetailEntry& entry : kDetails) all.push_back(entry.detail);
    return all;
  }();
  return details;
}

Severity severityOf(Detail detail) {
  return detail == Detail::equalPlanets ? Severity::info : severityOf(codeOf(detail));
}

bool hasErrors(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity() == Severity::error; });
}

void sortBySeverity(Diagnostics& diagnostics) {
  std::stable_sort(
      diagnostics.begin(), diagnostics.end(),
      [](const Diagnostic& one, const Diagnostic& other) { return one.severity() < other.severity(); });
}

}  // namespace geargraph
