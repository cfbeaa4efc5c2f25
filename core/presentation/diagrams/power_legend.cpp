#include "core/presentation/diagrams/power_legend.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/diagrams/band_marks.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxLoopsNamed = 3;

std::string percentText(double part) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), part >= 0.9995 ? "%.4g" : "%.3g", 100 * part);
  return localizedNumber(buffer.data()) + " %";
}

std::string labels(const std::vector<int>& numbers) {
  std::vector<std::string> names;
  for (const int number : numbers) names.push_back(std::to_string(number));
  constexpr std::size_t kMaxNames = 12;
  return listed(names, kMaxNames);
}

}  // namespace

Tint tintOfFlow(const DrawnFlow& flow, const Mechanism& mechanism) {
  const auto [least, most] =
      std::minmax_element(flow.ports.begin(), flow.ports.end(),
                          [](const DrawnPort& a, const DrawnPort& b) { return a.power < b.power; });
  const LinkOrdinal link = least->power < 0 ? least->link : most->link;
  return Tint::ofLink(mechanism.linkLabel(link), mechanism.colorNumber(link));
}

std::string flowText(double power, bool isKnown, bool isAssumed) {
  return isKnown ? powerText(power) + (isAssumed ? "*" : "") : "? W";
}

std::string shareText(const PowerPicture& picture, double power) {
  return picture.fed > 0 ? percentText(power / picture.fed) : std::string();
}

std::vector<LegendLine> powerLegend(const PowerPicture& picture, double largest, bool hasUnknown,
                                    bool hasAssumed) {
  std::vector<LegendLine> lines;
  lines.push_back({LegendLine::Mark::widest, powerText(largest),
                   picture.observer == 0
                       ? translated("seen from the ground")
                       : translated("seen from link %1", {std::to_string(picture.observer)})});
  for (std::size_t i = 0; i < std::min(picture.loops.size(), kMaxLoopsNamed); ++i) {
    const DrawnLoop& loop = picture.loops[i];
    lines.push_back(
        {LegendLine::Mark::circulating, powerText(loop.power),
         translated("circulates: links %1, meshes %2", {labels(loop.links), labels(loop.meshes)})});
  }
  if (hasUnknown)
    lines.push_back(
        {LegendLine::Mark::unknown, {}, translated("? W: shared in unknown parts, not determined")});
  if (hasAssumed)
    lines.push_back({LegendLine::Mark::none, {}, translated("* shared by equal stiffness: an assumption")});
  return lines;
}

}  // namespace geargraph
