#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "app/cli/arguments.h"

namespace geargraph::cli {

/// `--limit-seconds`, which every command knows.
extern const Option kLimitOption;

/// The seconds that the option gives; std::nullopt where it is not given.
[[nodiscard]] std::variant<std::optional<double>, UsageError> limitFrom(const Arguments& arguments);

/// Requests a stop when its time is over. The time begins with the object; without seconds it never ends.
class TimeLimit {
 public:
  explicit TimeLimit(std::optional<double> seconds);
  [[nodiscard]] std::stop_token token() const { return m_over.get_token(); }

 private:
  std::stop_source m_over;
  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::jthread m_clock;  ///< last: it ends before what it uses goes
};

/// Tells that `what` ("the analysis") was not finished in time; the exit status.
int outOfTime(const Arguments& arguments, const std::string& what);

}  // namespace geargraph::cli
