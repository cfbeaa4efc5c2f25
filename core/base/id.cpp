#include "core/base/id.h"

#include <mutex>
#include <shared_mutex>
#include <unordered_set>

#include "core/base/contract.h"

namespace geargraph {
namespace {

/// Lets the set be asked with a string_view, without making a string.
struct TextHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
};

/// The process's atoms. Nodes of an unordered_set never move, so their addresses are the identities.
struct AtomTable {
  std::shared_mutex mutex;
  std::unordered_set<std::string, TextHash, std::equal_to<>> texts;
};

AtomTable& atomTable() {
  static auto* table = new AtomTable;  // never destroyed: atoms in static objects outlive main()
  return *table;
}

}  // namespace

Atom::Atom(std::string_view text) {
  if (text.empty()) return;
  AtomTable& table = atomTable();
  {
    const std::shared_lock reading(table.mutex);
    if (const auto found = table.texts.find(text); found != table.texts.end()) {
      m_text = &*found;
      return;
    }
  }
  const std::unique_lock writing(table.mutex);
  m_text = &*table.texts.emplace(text).first;
}

const std::string& Atom::text() const {
  static const std::string empty;
  return m_text == nullptr ? empty : *m_text;
}

std::string_view listName(ElementKind kind) {
  switch (kind) {
    case ElementKind::link:
      return "links";
    case ElementKind::axis:
      return "axes";
    case ElementKind::turningJoint:
      return "turningJoints";
    case ElementKind::gearMesh:
      return "gearMeshes";
    case ElementKind::wheel:
      return "wheels";
    case ElementKind::coupling:
      return "couplings";
    case ElementKind::state:
      return "states";
  }
  GEARGRAPH_REQUIRE(false);
}

}  // namespace geargraph
