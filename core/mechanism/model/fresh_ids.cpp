#include "core/mechanism/model/fresh_ids.h"

#include <unordered_set>

namespace geargraph::inline model {

std::vector<std::string> freshIds(const Mechanism& mechanism, int count) {
  std::unordered_set<Atom> taken;
  for (const auto& e : mechanism.links) taken.insert(e.id.atom());
  for (const auto& e : mechanism.turningJoints) taken.insert(e.id.atom());
  for (const auto& e : mechanism.gearMeshes) taken.insert(e.id.atom());
  std::vector<std::string> fresh;
  for (int number = 1; static_cast<int>(fresh.size()) < count; ++number) {
    std::string text = std::to_string(number);
    if (!taken.contains(Atom(text))) fresh.push_back(std::move(text));
  }
  return fresh;
}

std::string freshId(const Mechanism& mechanism) {
  return freshIds(mechanism, 1).front();
}

std::vector<AxisId> freshAxisIds(const Mechanism& mechanism, int count) {
  std::unordered_set<Atom> taken;
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

}  // namespace geargraph::inline model
