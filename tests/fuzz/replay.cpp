// `fuzz_replay LAW FILE|FOLDER...`: checks a law on kept inputs, without libFuzzer. Prints the name of each
// before it is tried, so that the one which ends the program is known.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string_view>
#include <vector>

#include "tests/fuzz/laws.h"

namespace fs = std::filesystem;
using namespace geargraph::test;

namespace {

const std::map<std::string_view, void (*)(const std::string&)> kLaws = {
    {"reader", [](const std::string& input) { checkReader(input); }},
    {"analysis", [](const std::string& input) { checkAnalysis(input); }},
    {"table", [](const std::string& input) { checkTable(input); }},
    {"graph", [](const std::string& input) { checkGraph(input); }},
    {"tex", checkTex},
    {"exports", checkExports},
    {"mesh", checkMeshConfined},
    {"answer", checkMeshAnswer},
};

std::vector<fs::path> filesOf(int count, char** words) {
  std::vector<fs::path> files;
  for (int i = 2; i < count; ++i) {
    if (!fs::is_directory(words[i])) {
      files.emplace_back(words[i]);
      continue;
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(words[i])) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int count, char** words) {
  const auto law = count > 1 ? kLaws.find(words[1]) : kLaws.end();
  if (law == kLaws.end()) return 2;
  const std::vector<fs::path> files = filesOf(count, words);
  for (const fs::path& path : files) {
    std::fprintf(stderr, "%s\n", path.filename().c_str());
    std::ifstream file(path, std::ios::binary);
    law->second({std::istreambuf_iterator<char>(file), {}});
  }
  std::fprintf(stderr, "%s: %zu inputs hold\n", words[1], files.size());
  return files.empty() ? 1 : 0;
}
