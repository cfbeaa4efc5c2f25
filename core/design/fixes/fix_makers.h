#pragma once

#include "core/design/fixes/fixes.h"

namespace geargraph {

// The parts of fixesFor(), by diagnostic. Each may return more than kMaxFixes, the best first.

/// disconnected, turning-loop with its details.
[[nodiscard]] std::vector<Fix> treeFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot);
/// pitch-geometry, pitch-point-on-axis, teeth-geometry, coaxial-mesh, no-transfer-vertex, redundant-mesh,
/// split-axis.
[[nodiscard]] std::vector<Fix> meshFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot);
/// invalid-inputs.
[[nodiscard]] std::vector<Fix> inputFixes(const AnalysisSnapshot& snapshot);
/// redundant-coupling, and locked by engaged couplings.
[[nodiscard]] std::vector<Fix> couplingFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot);
/// interference/bodies-overlap and wheels-overlap: moves a joint along its axis.
[[nodiscard]] std::vector<Fix> overlapFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot);
/// assembly, undercut, locked, dead-joint.
[[nodiscard]] std::vector<Fix> teethFixes(const Diagnostic& diagnostic, const AnalysisSnapshot& snapshot);

/// assembly: the nearest number of equally spaced planets that fits; `planet` is one of them. Empty for
/// planets of several links.
[[nodiscard]] std::vector<Fix> planetCountFixes(const Mechanism& mechanism, LinkId planet);
/// assembly/unequal-planets: tooth counts and numbers of planets with which they are equal parts.
[[nodiscard]] std::vector<Fix> unequalPlanetFixes(const Diagnostic& diagnostic, const Mechanism& mechanism);

/// The fix that deletes an element. `why`: appended to its text.
[[nodiscard]] Fix removalOf(const AnalysisSnapshot& snapshot, const ElementId& element,
                            const std::string& why = {});

/// "link 3", "joint 8", "mesh 15"
[[nodiscard]] std::string wordFor(const Mechanism& mechanism, const ElementId& element);

/// The fixes without those that are rejected, change nothing, or after which `stillWrong` holds.
template <class StillWrong>
[[nodiscard]] std::vector<Fix> tried(std::vector<Fix> fixes, const Mechanism& mechanism,
                                     const StillWrong& stillWrong) {
  std::erase_if(fixes, [&](const Fix& fix) {
    const Expected<Mechanism> repaired = fix.edit(mechanism);
    return !repaired || *repaired == mechanism || stillWrong(*repaired);
  });
  return fixes;
}

}  // namespace geargraph
