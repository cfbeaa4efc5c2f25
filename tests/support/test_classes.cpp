#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "tests/support/test_class.h"

namespace geargraph::test {
namespace {

using Run = int (*)(int, char**);

std::map<std::string, Run, std::less<>>& testClasses() {
  static std::map<std::string, Run, std::less<>> classes;
  return classes;
}

std::string stemOf(std::string_view path) {
  path.remove_prefix(path.find_last_of("/\\") + 1);
  return std::string(path.substr(0, path.find_last_of('.')));
}

}  // namespace

bool addTestClass(const char* file, Run run) {
  const auto [place, added] = testClasses().emplace(stemOf(file), run);
  if (!added) qFatal("Two test classes are named %s.", place->first.c_str());
  return true;
}

}  // namespace geargraph::test

int main(int count, char** words) {
  const auto& classes = geargraph::test::testClasses();
  const auto found = count > 1 ? classes.find(std::string_view(words[1])) : classes.end();
  if (found != classes.end()) {
    words[1] = words[0];
    return found->second(count - 1, words + 1);
  }
  std::fprintf(stderr, "Name one of these test classes, then the arguments of Qt Test:\n");
  for (const auto& [name, run] : classes) std::fprintf(stderr, "  %s\n", name.c_str());
  return 2;
}
