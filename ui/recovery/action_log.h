#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace geargraph {

/// The names of the user's last actions, for crash reports: never typed text, file names or content of a
/// document. One thread writes; a signal handler on any thread may read, and at worst sees a name that is
/// being written.
class ActionLog {
 public:
  static constexpr std::size_t kCapacity = 64;
  static constexpr std::size_t kMaxNameLength = 63;  ///< bytes; longer names are truncated

  struct Entry {
    std::array<char, kMaxNameLength + 1> name{};
    std::int64_t milliseconds = 0;  ///< of the steady clock, at the last repetition
    std::uint32_t count = 0;        ///< consecutive repetitions
  };

  /// Records an action; a repetition of the last one is counted.
  void note(std::string_view name);
  /// Calls visit(entry) for each, the oldest first. Allocates nothing.
  template <class Visit>
  void visit(const Visit& visit) const {
    const std::uint64_t end = m_count.load(std::memory_order_acquire);
    for (std::uint64_t i = end > kCapacity ? end - kCapacity : 0; i < end; ++i)
      visit(m_entries[i % kCapacity]);
  }

  /// The steady clock in milliseconds; async-signal-safe.
  [[nodiscard]] static std::int64_t now();

 private:
  std::array<Entry, kCapacity> m_entries{};
  std::atomic<std::uint64_t> m_count{0};
};

/// The log of the program.
[[nodiscard]] ActionLog& actionLog();

}  // namespace geargraph
