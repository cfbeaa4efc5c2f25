// Writes the trains that the benchmarks share with their peers in other languages: geargraph_bench_trains
// FOLDER

#include <cstdio>
#include <initializer_list>
#include <string>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "tests/bench/families.h"
#include "tests/core/support/deep_train.h"

namespace geargraph {
namespace {

Mechanism deepTrain(int links) {
  return test::deepTrain(1, links);
}

Mechanism deepCoupledTrain(int links) {
  return bench::drivenAtRandom(deepTrain(links));
}

/// Writes a family's trains; false (and reported) where one could not be written.
bool writeFamily(const std::string& folder, const char* family, Mechanism (*train)(int),
                 std::initializer_list<int> sizes) {
  for (const int links : sizes) {
    const std::string path = folder + "/" + family + "-" + std::to_string(links) + ".geargraph";
    if (const auto error = writeFile(path, writeMechanism(train(links)))) {
      std::fprintf(stderr, "%s\n", error->message.c_str());
      return false;
    }
  }
  return true;
}

}  // namespace
}  // namespace geargraph

int main(int count, char** arguments) {
  using namespace geargraph;
  if (count != 2) {
    std::fprintf(stderr, "usage: geargraph_bench_trains FOLDER\n");
    return 2;
  }
  const std::string folder = arguments[1];
  const bool areWritten =
      writeFamily(folder, "tree", &bench::drivenTree, {7, 20, 80, 1000, 3000, 10000, 30000}) &&
      writeFamily(folder, "coupled", &bench::coupledTree, {7, 20, 80, 1000, 10000}) &&
      writeFamily(folder, "deep", &deepTrain, {1000, 3000, 10000, 30000}) &&
      writeFamily(folder, "deep-coupled", &deepCoupledTrain, {1000, 3000});
  return areWritten ? 0 : 2;
}
