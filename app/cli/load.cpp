#include "app/cli/load.h"

#include "core/io/mechanism_file.h"

namespace geargraph::cli {

std::variant<Expected<Mechanism>, FileError> load(const std::string& path) {
  auto bytes = readFile(path, kLargestFile);
  if (auto* error = std::get_if<FileError>(&bytes)) return std::move(*error);
  return readMechanism(std::get<std::string>(bytes));
}

}  // namespace geargraph::cli
