#include "tests/soak/soak_options.h"

#include <cstdio>
#include <cstdlib>

namespace geargraph::soak {

std::optional<SoakOptions> readOptions(int argc, char** argv, const std::string& counted) {
  SoakOptions options;
  bool isValid = true;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name.rfind("--", 0) != 0) {
      options.documents.push_back(name);
      continue;
    }
    if (name == "--stacks") {
      options.stacks = true;
      continue;
    }
    char* end = nullptr;
    const double value = ++i < argc ? std::strtod(argv[i], &end) : 0;
    isValid = isValid && end != nullptr && *end == '\0' && value >= 0;
    if (name == "--seed") {
      options.seed = static_cast<std::uint64_t>(value);
    } else if (name == counted) {
      options.count = static_cast<long>(value);
    } else if (name == "--minutes") {
      options.minutes = value;
    } else if (name == "--slack") {
      options.slack = value;
    } else {
      isValid = false;
    }
  }
  if (isValid && (options.count || options.minutes)) return options;
  std::fprintf(stderr, "usage: %s [--seed N] %s N | --minutes M [--slack F] [--stacks] [DOCUMENT ...]\n",
               argv[0], counted.c_str());
  return std::nullopt;
}

}  // namespace geargraph::soak
