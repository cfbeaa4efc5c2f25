#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace geargraph::inline crash {

/// The last actions of the user by their names, for crash reports: never a text that was typed, the name of a
/// file or anything of a document. One thread writes; a signal handler of any thread may read, and then at
/// worst sees a name that is being written.
class ActionLog {
 public:
  static constexpr std::size_t kCapacity = 64;
  static constexpr std::size_t kLongestName = 63;  ///< bytes; longer names are cut

  struct Entry {
    std::array<char, kLongestName + 1> name{};
    std::int64_t milliseconds = 0;  ///< of the steady clock, at the last repetition
    std::uint32_t count = 0;        ///< repetitions in a row
  };

  /// Notes an action; a repetition of the last one is counted.
  void note(std::string_view name);
  /// Calls visit(entry) for each, the oldest first. Allocates nothing.
  template <class Visit>
  void visit(const Visit& visit) const {
    const std::uint64_t end = m_count.load(std::memory_order_acquire);
    for (std::uint64_t i = end > kCapacity ? end - kCapacity : 0; i < end; ++i)
      visit(m_entries[i % kCapacity]);
  }

  /// The steady clock in milliseconds; may be called in a signal handler.
  [[nodiscard]] static std::int64_t now();

 private:
  std::array<Entry, kCapacity> m_entries{};
  std::atomic<std::uint64_t> m_count{0};
};

/// The log of the program.
[[nodiscard]] ActionLog& actionLog();

}  // namespace geargraph::inline crash
