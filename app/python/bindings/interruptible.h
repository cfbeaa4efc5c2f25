#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <type_traits>
#include <utility>

namespace geargraph::python {

/// Runs long work on a background thread with the GIL released, while the caller waits and checks for
/// signals: Ctrl+C requests a stop, waits until the work has ended, and raises KeyboardInterrupt. The work
/// must not use Python. Its exceptions are rethrown. Cost: starting a thread, some tens of microseconds.
void runInterruptible(const std::function<void(const std::stop_token&)>& work);

/// The same for work with a result.
template <class Work>
[[nodiscard]] auto interruptible(const Work& work) {
  std::optional<std::invoke_result_t<const Work&, const std::stop_token&>> result;
  runInterruptible([&](const std::stop_token& stop) { result.emplace(work(stop)); });
  return *std::move(result);
}

}  // namespace geargraph::python
