#include "core/foundations/base/id.h"

#include <array>
#include <atomic>
#include <bit>
#include <limits>
#include <mutex>
#include <shared_mutex>
#include <unordered_map>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

/// The process's texts by number. They stand in blocks, each twice as large as the one before, and never
/// move: a text is read without a lock while others are added.
class AtomTable {
 public:
  std::uint32_t numberOf(std::string_view text) {
    {
      const std::shared_lock reading(m_mutex);
      if (const auto found = m_numbers.find(text); found != m_numbers.end()) return found->second;
    }
    const std::unique_lock writing(m_mutex);
    if (const auto found = m_numbers.find(text); found != m_numbers.end()) return found->second;
    GEARGRAPH_REQUIRE(m_last < std::numeric_limits<std::uint32_t>::max());
    const std::uint32_t number = ++m_last;
    std::atomic<std::string*>& block = m_blocks[blockOf(number)];
    if (block == nullptr) block = new std::string[sizeOf(number)];  // never deleted, as the table is not
    std::string& stored = block[placeOf(number)];
    stored = text;
    m_numbers.emplace(stored, number);
    return number;
  }

  [[nodiscard]] const std::string& text(std::uint32_t number) const {
    return m_blocks[blockOf(number)].load(std::memory_order_acquire)[placeOf(number)];
  }

 private:
  // Block k holds the numbers 2^k .. 2^(k+1) - 1.
  static std::size_t blockOf(std::uint32_t number) { return std::bit_width(number) - 1U; }
  static std::size_t sizeOf(std::uint32_t number) { return std::bit_floor(number); }
  static std::size_t placeOf(std::uint32_t number) { return number - std::bit_floor(number); }

  std::shared_mutex m_mutex;
  std::unordered_map<std::string_view, std::uint32_t> m_numbers;
  std::array<std::atomic<std::string*>, 32> m_blocks{};
  std::uint32_t m_last = 0;
};

AtomTable& atomTable() {
  static auto* table = new AtomTable;  // never destroyed: atoms in static objects outlive main()
  return *table;
}

}  // namespace

InternedString::InternedString(std::string_view text)
    : m_number(text.empty() ? 0 : atomTable().numberOf(text)) {}

const std::string& InternedString::text() const {
  static const std::string empty;
  return m_number == 0 ? empty : atomTable().text(m_number);
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
    case ElementKind::load:
      return "loads";
    case ElementKind::note:
      return "view/notes";
  }
  GEARGRAPH_REQUIRE(false);
}

}  // namespace geargraph
