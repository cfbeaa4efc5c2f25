#include "core/mechanism/model/fresh_ids.h"

#include <charconv>
#include <unordered_set>

namespace geargraph {

namespace {

/// Marks the numbers that elements of the list have as ids. A number is looked for in the texts
/// and not the other way round, because interning thousands of numbers costs tens of milliseconds.
template <class List>
void markNumbers(const List& list, std::vector<bool>& taken) {
  for (const auto& element : list) {
    const std::string& text = element.id.text();
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool isNumber = error == std::errc() && end == text.data() + text.size() && text.front() != '0';
    if (isNumber && number < taken.size()) taken[number] = true;
  }
}

}  // namespace

std::vector<std::string> freshIds(const Mechanism& mechanism, int count) {
  const std::size_t elements =
      mechanism.links.size() + mechanism.turningJoints.size() + mechanism.gearMeshes.size();
  std::vector<bool> taken(elements + static_cast<std::size_t>(count) + 1);
  markNumbers(mechanism.links, taken);
  markNumbers(mechanism.turningJoints, taken);
  markNumbers(mechanism.gearMeshes, taken);
  std::vector<std::string> fresh;
  for (std::size_t number = 1; fresh.size() < static_cast<std::size_t>(count); ++number) {
    if (!taken[number]) fresh.push_back(std::to_string(number));
  }
  return fresh;
}

std::string freshId(const Mechanism& mechanism) {
  return freshIds(mechanism, 1).front();
}

std::vector<AxisId> freshAxisIds(const Mechanism& mechanism, int count) {
  std::unordered_set<InternedString> taken;
  for (const Axis& axis : mechanism.axes) taken.insert(axis.id.atom());
  std::vector<AxisId> fresh;
  for (int round = 0; static_cast<int>(fresh.size()) < count; ++round) {
    for (char letter = 'a'; letter <= 'z' && static_cast<int>(fresh.size()) < count; ++letter) {
      const AxisId id(round == 0 ? std::string(1, letter) : letter + std::to_string(round));
      if (!taken.contains(id.atom())) fresh.push_back(id);
    }
  }
  return fresh;
}

}  // namespace geargraph
