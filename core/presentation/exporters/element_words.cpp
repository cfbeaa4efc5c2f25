#include "core/presentation/exporters/element_words.h"

#include <algorithm>

#include "core/foundations/base/translation.h"

namespace geargraph {
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

std::variant<std::vector<JointOrdinal>, UsageError> jointsNamed(const Mechanism& mechanism,
                                                                std::string_view option,
                                                                std::string_view text) {
  std::vector<JointOrdinal> joints;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    const auto joint = jointNamed(mechanism, word);
    if (!joint) return UsageError{translated("%1: there is no turning joint \"%2\".", {option, word})};
    if (std::find(joints.begin(), joints.end(), *joint) != joints.end())
      return UsageError{translated("%1: joint %2 is named twice.", {option, word})};
    joints.push_back(*joint);
    begin = end + 1;
  }
  return joints;
}

}  // namespace geargraph
