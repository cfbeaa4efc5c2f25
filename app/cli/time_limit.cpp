#include "app/cli/time_limit.h"

#include <chrono>
#include <cmath>
#include <iostream>

#include "app/cli/command.h"
#include "core/foundations/base/translation.h"

namespace geargraph::cli {
namespace {

constexpr double kMaxLength = 1e6;  // s

}  // namespace

const Option kLimitOption{"--limit-seconds", "S",
                          toTranslate("give up after this time (exit status 3); nothing is written then")};

std::variant<std::optional<double>, UsageError> limitFrom(const Arguments& arguments) {
  const auto text = arguments.value(kLimitOption.name);
  if (!text) return std::optional<double>();
  const auto seconds = numberFrom<double>(*text);
  if (seconds && *seconds > 0 && *seconds <= kMaxLength) return seconds;
  return UsageError{
      translated("--limit-seconds takes a number of seconds above 0, up to 1000000, not \"%1\".", {*text})};
}

TimeLimit::TimeLimit(std::optional<double> seconds) {
  if (!seconds) return;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::nanoseconds>(
                                                          std::chrono::duration<double>(*seconds));
  m_clock = std::jthread([this, end](const std::stop_token& finished) {
    std::unique_lock lock(m_mutex);
    m_wake.wait_until(lock, finished, end, [] { return false; });
    if (!finished.stop_requested()) m_over.request_stop();
  });
}

int outOfTime(const Arguments& arguments, const std::string& what) {
  std::cerr << "geargraph-cli: "
            << translated("The limit of %1 s was over before %2 was finished; nothing was written.",
                          {*arguments.value(kLimitOption.name), what})
            << '\n';
  return kResourceLimit;
}

}  // namespace geargraph::cli
