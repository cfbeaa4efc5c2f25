#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <type_traits>
#include <utility>

namespace geargraph::python {

/// Runs work that may take long on a thread of its own, without the interpreter's lock, while the caller
/// waits and looks for signals: Ctrl+C requests a stop, waits until the work has ended, and raises
/// KeyboardInterrupt. The work must not touch Python. Its exceptions are passed on.
/// Cost: a thread, some tens of microseconds.
void runInterruptible(const std::function<void(const std::stop_token&)>& work);

/// The same of work with a result.
template <class Work>
[[nodiscard]] auto interruptible(const Work& work) {
  std::optional<std::invoke_result_t<const Work&, const std::stop_token&>> result;
  runInterruptible([&](const std::stop_token& stop) { result.emplace(work(stop)); });
  return *std::move(result);
}

}  // namespace geargraph::python
