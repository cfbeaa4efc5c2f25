#pragma once

#include <any>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace geargraph::test {

/// Work that a stop token ends. The result is returned, so that it is not freed inside what is measured.
using StoppableWork = std::function<std::any(const std::stop_token&)>;

struct NamedWork {
  std::string name;
  StoppableWork work;
};

/// Each kind of long work on the worst documents known; pictures are written into `folder`. Loads the
/// graphics driver first, which the system does once a process and nothing stops.
[[nodiscard]] std::vector<NamedWork> stoppableWorks(const std::filesystem::path& folder);

}  // namespace geargraph::test
