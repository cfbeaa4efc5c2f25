#include "core/presentation/exporters/element_words.h"

#include <algorithm>

#include "core/presentation/exporters/option_values.h"

namespace geargraph::inline exporters {
namespace {

template <class Elements>
std::optional<int> positionOf(const Elements& elements, int firstLabel, std::string_view word) {
  const auto count = static_cast<int>(elements.size());
  if (const auto label = numberFrom<int>(word)) {
    const int position = *label - firstLabel;
    if (position >= 0 && position < count) return position;
  }
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [word](const auto& element) { return element.id.text() == word; });
  if (found == elements.end()) return std::nullopt;
  return static_cast<int>(found - elements.begin());
}

}  // namespace

std::optional<JointOrdinal> jointNamed(const Mechanism& mechanism, std::string_view word) {
  return positionOf(mechanism.turningJoints, mechanism.jointLabel(0), word);
}

std::optional<LinkOrdinal> linkNamed(const Mechanism& mechanism, std::string_view word) {
  return positionOf(mechanism.links, mechanism.linkLabel(0), word);
}

}  // namespace geargraph::inline exporters
