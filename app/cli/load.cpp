#include "app/cli/load.h"

#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph::cli {

std::variant<Expected<Mechanism>, FileError> load(const std::string& path) {
  auto bytes = readFile(path, kLargestFile);
  if (auto* error = std::get_if<FileError>(&bytes)) return std::move(*error);
  return readMechanism(std::get<std::string>(bytes));
}

std::variant<Mechanism, int> loadOrSay(const std::string& path) {
  auto loaded = load(path);
  if (const auto* error = std::get_if<FileError>(&loaded)) return fileFailure(error->message);
  auto& document = std::get<Expected<Mechanism>>(loaded);
  if (document) return std::move(document).value();
  std::cerr << diagnosticLines(path, document.error());
  return static_cast<int>(kMechanismErrors);
}

}  // namespace geargraph::cli
