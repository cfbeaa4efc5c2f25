#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "app/cli/arguments.h"

namespace geargraph::cli {

/// `--limit-seconds`, common to all commands.
extern const Option kLimitOption;

/// The option's seconds; std::nullopt if it is not given.
[[nodiscard]] std::variant<std::optional<double>, UsageError> limitFrom(const Arguments& arguments);

/// Requests a stop after `seconds` from construction; never without a value.
class TimeLimit {
 public:
  explicit TimeLimit(std::optional<double> seconds);
  [[nodiscard]] std::stop_token token() const { return m_over.get_token(); }

 private:
  std::stop_source m_over;
  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::jthread m_clock;  ///< last: stopped before the members it uses are destroyed
};

/// Reports that `what` ("the analysis") was not finished in time; returns the exit status.
int outOfTime(const Arguments& arguments, const std::string& what);

}  // namespace geargraph::cli
