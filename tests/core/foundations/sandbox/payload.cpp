// `sandbox_payload WALLS FOLDER` behaves as a reader that a hostile file has taken over: it closes the walls
// named
// ("none", "landlock", "filter", "all") and prints what it could still do.

#include <sys/prctl.h>
#include <unistd.h>

#include <string_view>

#include "core/foundations/sandbox/sandbox.h"
#include "tests/core/foundations/sandbox/attempts.h"

int main(int count, char** words) {
  using namespace geargraph;
  if (count != 3) return 2;
  const std::string_view walls = words[1];
  if (walls == "landlock" && !(renouncePrivileges() && forbidFiles())) return 3;
  if (walls == "filter" && !(renouncePrivileges() && filterCalls() == 0)) return 3;
  if (walls == "all" && enterSandbox({std::size_t{1} << 30U, 10})) return 3;
  const std::string report = test::hostileAttempts(words[2]);
  const ssize_t written = ::write(STDOUT_FILENO, report.data(), report.size());
  ::_exit(written == static_cast<ssize_t>(report.size()) ? 0 : 4);
}
