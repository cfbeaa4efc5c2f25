#include "ui/recovery/action_log.h"

#include <algorithm>
#include <cstring>
#include <ctime>

namespace geargraph {

std::int64_t ActionLog::now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * 1000LL + time.tv_nsec / 1'000'000;
}

void ActionLog::note(std::string_view name) {
  name = name.substr(0, kMaxNameLength);
  const std::uint64_t count = m_count.load(std::memory_order_relaxed);
  if (count > 0) {
    Entry& last = m_entries[(count - 1) % kCapacity];
    if (name == last.name.data()) {
      last.milliseconds = now();
      ++last.count;
      return;
    }
  }
  Entry& entry = m_entries[count % kCapacity];
  entry.name.fill('\0');
  std::copy(name.begin(), name.end(), entry.name.begin());
  entry.milliseconds = now();
  entry.count = 1;
  m_count.store(count + 1, std::memory_order_release);
}

ActionLog& actionLog() {
  static constinit ActionLog log;
  return log;
}

}  // namespace geargraph
