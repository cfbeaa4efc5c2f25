#include "app/cli/command.h"

#include <unistd.h>

#include <array>
#include <iostream>

#include "core/foundations/files/file.h"

namespace geargraph::cli {

std::span<const Command* const> commands() {
  static constexpr std::array kCommands = {&kAnalyze,  &kValidate, &kInputs, &kStates, &kStatics,
                                           &kDynamics, &kExport,   &kPose,   &kSummary};
  return kCommands;
}

int wrongUsage(const Command& command, std::string_view message) {
  std::cerr << "geargraph-cli " << command.name << ": " << message << "\nUsage: geargraph-cli "
            << command.name << ' ' << command.usage << "\nMore: geargraph-cli " << command.name
            << " --help\n";
  return kUsageOrFile;
}

int fileFailure(std::string_view message) {
  std::cerr << "geargraph-cli: " << message << '\n';
  return kUsageOrFile;
}

int print(std::string_view text, int fine) {
  DescriptorSink out(STDOUT_FILENO);
  out.write(text);
  return out.failed() ? fileFailure("Standard output could not be written.") : fine;
}

}  // namespace geargraph::cli
