#include "ui/lever_views/speed_drag.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "core/mechanism/model/edits.h"

namespace geargraph {

std::optional<SpeedHandle> handleOn(const DrawnLevers& drawn, LinkOrdinal link) {
  const int position = drawn.picture.plan.positionOf(link);
  if (position < 0 || drawn.picture.speeds.empty()) return std::nullopt;
  const auto at = static_cast<std::size_t>(position);
  std::optional<std::size_t> best;
  for (std::size_t input = 0; input < drawn.perInput.size(); ++input) {
    if (drawn.perInput[input][at].isZero()) continue;
    const DigraphEdge& joint = drawn.snapshot->graph->turningEdge(JointOrdinal(drawn.inputs[input]));
    const bool isItsOwn = joint.head == link || joint.tail == link;
    if (!best || isItsOwn) best = input;
    if (isItsOwn) break;
  }
  if (!best) return std::nullopt;
  SpeedHandle handle;
  handle.input = *best;
  handle.joint = JointId(drawn.snapshot->graph->edgeId(drawn.inputs[*best]).id);
  handle.perInput = drawn.perInput[*best][at];
  handle.link = drawn.picture.speeds[at];
  handle.now = drawn.speeds[*best];
  return handle;
}

Edit inputSpeedEdit(const DrawnLevers& drawn, const SpeedHandle& handle, const Number& speed,
                    quint64 gesture) {
  std::vector<Input> chosen;
  for (std::size_t i = 0; i < drawn.inputs.size(); ++i)
    chosen.push_back(
        {JointId(drawn.snapshot->graph->edgeId(drawn.inputs[i]).id), Number(drawn.speeds[i]), {}});
  return {QCoreApplication::translate("ui_levers", "Set speed"),
          [chosen, joint = handle.joint, speed](const Mechanism& before) {
            std::vector<Input> inputs = before.inputs.value_or(chosen);
            for (Input& input : inputs) {
              if (input.joint == joint) input.speed = speed;
            }
            return withInputs(before, std::move(inputs));
          },
          gesture};
}

Number handSet(double speed, double perPixel) {
  constexpr int kMaxDigits = 9;
  const int digits =
      std::clamp(static_cast<int>(std::ceil(-std::log10(perPixel) - 1e-9)), -kMaxDigits, kMaxDigits);
  const double unit = std::pow(10.0, digits);
  const double rounded = std::round(speed * unit) / unit;
  return Number::fromDouble(rounded == 0 ? 0.0 : rounded);
}

}  // namespace geargraph
