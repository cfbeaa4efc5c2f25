// Writes the trains that the benchmarks share with their peers in other languages: geargraph_bench_trains
// FOLDER

#include <cstdio>
#include <string>
#include <utility>

#include "core/io/file.h"
#include "core/io/mechanism_file.h"
#include "tests/bench/families.h"

int main(int count, char** arguments) {
  using namespace geargraph;
  if (count != 2) {
    std::fprintf(stderr, "usage: geargraph_bench_trains FOLDER\n");
    return 2;
  }
  const std::pair<const char*, Mechanism (*)(int)> families[] = {{"tree", &bench::drivenTree},
                                                                 {"coupled", &bench::coupledTree}};
  for (const auto& [family, train] : families) {
    for (const int links : {7, 20, 80, 1000, 10000}) {
      const std::string path =
          std::string(arguments[1]) + "/" + family + "-" + std::to_string(links) + ".geargraph";
      if (const auto error = writeFile(path, writeMechanism(train(links)))) {
        std::fprintf(stderr, "%s\n", error->message.c_str());
        return 2;
      }
    }
  }
  return 0;
}
