#pragma once

#include <string>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::test {

/// A file or folder of the checkout: sourcePath("tests/golden/files/loose.geargraph").
[[nodiscard]] std::string sourcePath(const std::string& path);

/// The file of an example in resources/examples: examplePath("robot").
[[nodiscard]] std::string examplePath(const std::string& name);

/// The names of all examples, in the order of the alphabet.
[[nodiscard]] std::vector<std::string> exampleNames();

/// The text of an example's file. A file that cannot be read ends the test program.
[[nodiscard]] std::string exampleText(const std::string& name);

/// An example, read from its file. One that cannot be read ends the test program.
[[nodiscard]] Mechanism example(const std::string& name);

}  // namespace geargraph::test
