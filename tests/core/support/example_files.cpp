#include "tests/core/support/example_files.h"

#include <algorithm>
#include <filesystem>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"

namespace geargraph::test {

std::string sourcePath(const std::string& path) {
  return GEARGRAPH_SOURCE_DIR "/" + path;
}

std::string examplePath(const std::string& name) {
  return sourcePath("resources/examples/" + name + ".geargraph");
}

std::vector<std::string> exampleNames() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(sourcePath("resources/examples"))) {
    if (entry.path().extension() == ".geargraph") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());  // the folder's own order differs from disk to disk
  return names;
}

std::string exampleText(const std::string& name) {
  return std::get<std::string>(readFile(examplePath(name), kLargestFile));
}

Mechanism example(const std::string& name) {
  return readMechanism(exampleText(name)).value();
}

}  // namespace geargraph::test
