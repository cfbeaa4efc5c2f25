#include "core/presentation/schematic/section_symbols.h"

#include "core/presentation/schematic/shaft_plan.h"

namespace geargraph {

std::vector<std::vector<CanvasPoint>> hatching(CanvasPoint from, CanvasPoint to, CanvasPoint out) {
  constexpr double kStep = 6;
  std::vector<std::vector<CanvasPoint>> strokes;
  const CanvasPoint way = unit(to - from);
  const double whole = distance(from, to);
  const auto count = static_cast<int>(whole / kStep);
  const double start = (whole - count * kStep) / 2;
  for (int k = 0; k <= count; ++k) {
    const CanvasPoint foot = from + (start + k * kStep) * way;
    strokes.push_back({foot, foot + kHatching * out - 0.8 * kHatching * way});
  }
  return strokes;
}

TurnArrow turnArrow(CanvasPoint center, CanvasPoint along, double reach) {
  constexpr double kBulge = 8;
  constexpr double kTip = 7;
  const CanvasPoint across = turned(along);
  const CanvasPoint start = center + reach * across - 0.3 * kBulge * along;
  const CanvasPoint end = center - reach * across - 0.3 * kBulge * along;
  TurnArrow arrow;
  arrow.bow = {start, start + kBulge * along - 0.1 * reach * across,
               end + kBulge * along + 0.1 * reach * across, end};
  const CanvasPoint way = arrow.bow.direction(1);
  const CanvasPoint tip = end + 0.5 * kTip * way;
  arrow.tip = {tip, tip - kTip * way + 0.45 * kTip * turned(way),
               tip - kTip * way - 0.45 * kTip * turned(way)};
  arrow.bow = arrow.bow.part(0, 0.9);
  return arrow;
}

}  // namespace geargraph
