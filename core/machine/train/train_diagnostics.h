#pragma once

#include <cstdint>
#include <stop_token>

#include "core/machine/teeth/phase.h"
#include "core/machine/train/train.h"
#include "core/mechanism/placement/placement.h"

namespace geargraph {

/// `undercut` and `interference` of the train's gears and pairs, with the values that would avoid them.
/// Incomplete if `stop` was requested meanwhile.
[[nodiscard]] Diagnostics toothDiagnostics(const Mechanism& mechanism, const GearTrain& train,
                                           const std::stop_token& stop = {});

/// `interference` of adjacent wheels around one gear whose tips collide: planets of one carrier with 2 a
/// sin(angle / 2) less than the sum of their tip radii. Cost: O(meshes log meshes).
[[nodiscard]] Diagnostics neighbourDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                               const GearTrain& train);

/// `assembly` for every mesh whose residual exceeds kPhaseFits, with the nearest positions or tooth counts
/// that fit. Incomplete if `stop` was requested meanwhile.
[[nodiscard]] Diagnostics assemblyDiagnostics(const Mechanism& mechanism, const GearTrain& train,
                                              const std::stop_token& stop = {});

/// `assembly/unequal-planets` for planets that are drawn equal (equalPlanets()) and whose gears on one body
/// would have to be turned against each other differently, with positions and numbers of planets that fit.
/// Sets with a loop that cannot be assembled at all are left out. Incomplete if `stop` was requested
/// meanwhile.
[[nodiscard]] Diagnostics planetDiagnostics(const Mechanism& mechanism, const Placement& placement,
                                            const GearTrain& train, const std::stop_token& stop = {});

/// The number of equally spaced planets nearest to `count` that divides the number of places at which a
/// planet fits and leaves their tips clear of each other; 0: none near. `orbit`: distance of their axes from
/// the central one.
[[nodiscard]] int nearestPlanetCount(int count, std::int64_t places, double orbit, double tip);

/// A number for a sentence, with `digits` decimals.
[[nodiscard]] std::string fixedText(double value, int digits);

[[nodiscard]] inline Diagnostic makeDiagnostic(Detail detail, std::string message,
                                               std::vector<ElementId> elements) {
  Diagnostic d;
  d.code = codeOf(detail);
  d.detail = detail;
  d.message = std::move(message);
  d.elements = std::move(elements);
  return d;
}

}  // namespace geargraph
