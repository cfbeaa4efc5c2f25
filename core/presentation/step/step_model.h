#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>

#include "core/foundations/base/diagnostic.h"
#include "core/machine/train/train.h"
#include "core/mechanism/model/mechanism.h"
#include "core/presentation/brep/brep.h"

namespace geargraph {

/// What is asked of a CAD file.
struct StepChoice {
  double deviation = 1e-3;               ///< of teeth from their exact form, modules
  const TrainGear* gear = nullptr;       ///< only this one, in its own frame
  std::optional<LinkOrdinal> link = {};  ///< only what belongs to it
};

/// The train as an assembly of its links, each of its wheels and its body.
struct StepModel {
  CadAssembly assembly;
  double deviation = 0;  ///< the largest of all teeth, modules: not above what was asked, or else said
  std::size_t faces = 0;
};

struct StepFailure {
  enum class Kind { stopped, gears, nothing, tooLarge };
  Kind kind = Kind::stopped;
  Diagnostics diagnostics = {};
  std::size_t faces = 0;
};

constexpr std::size_t kMaxStepFaces = 150'000;

/// `millimetres`: of a unit of length of the mechanism. `colour`: of a link, by the number of its colour.
/// Cost: O(teeth), tenths of a second for the wheel of a worm.
[[nodiscard]] std::variant<StepModel, StepFailure> stepModel(
    const Mechanism& mechanism, const GearTrain& train, const std::string& name, double millimetres,
    const std::function<std::array<float, 3>(int)>& colour, const StepChoice& choice,
    const std::stop_token& stop);

}  // namespace geargraph
