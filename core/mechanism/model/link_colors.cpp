#include "core/mechanism/model/link_colors.h"

#include <unordered_set>

namespace geargraph {

LinkColors::LinkColors(const Mechanism& before) {
  m_numbers.reserve(before.links.size());
  for (int link = 1; link <= before.n(); ++link)
    m_numbers.emplace(before.links[static_cast<std::size_t>(link)].id, before.colorNumber(link));
}

void LinkColors::keepIn(Mechanism& after) const {
  std::unordered_set<int> taken;
  for (int link = 1; link <= after.n(); ++link) {
    const auto had = m_numbers.find(after.links[static_cast<std::size_t>(link)].id);
    if (had != m_numbers.end()) taken.insert(had->second);
  }
  int free = 1;
  for (int link = 0; link <= after.n(); ++link) {
    const LinkId id = after.links[static_cast<std::size_t>(link)].id;
    const int label = after.linkLabel(link);
    const auto had = m_numbers.find(id);
    int number = label;
    if (link > 0 && had != m_numbers.end()) {
      number = had->second;
    } else if (link > 0 && !taken.insert(label).second) {
      while (!taken.insert(free).second) ++free;
      number = free;
    }
    if (number == label) {
      after.view.colors.erase(id);
    } else {
      after.view.colors[id] = number;
    }
  }
}

}  // namespace geargraph
