// The reader against hostile bytes: seeded mutations of valid files, and random bytes. Whatever comes, it
// returns; what it accepts round-trips to the same value and the same bytes; and it takes for JSON exactly
// what an independent reader (nlohmann's) takes for JSON, apart from its own limits.

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "tests/core/mechanism/document_format/support.h"
#include "tests/core/support/example_files.h"
#include "tests/fuzz/laws.h"
#include "tests/fuzz/mutations.h"

using namespace geargraph;
using test::below;
using test::kPieces;
using test::mutate;
using test::Random;

int main(int count, char** arguments) {
  const long rounds = count > 1 ? std::atol(arguments[1]) : 1000;
  const std::vector<std::string> seeds = {
      test::kEverything, test::exampleText("robot"),
      R"({"format":"geargraph","version":1,"links":[{"id":0},{"id":1}],"turningJoints":[{"id":2,"tail":0,"head":1,"axis":"a"}],"axes":[{"id":"a"}]})"};
  Random random(20240607);
  long accepted = 0;
  for (long round = 0; round < rounds; ++round) {
    std::string text = seeds[below(random, seeds.size())];
    if (round % 50 == 0) {
      text.assign(below(random, 200), '\0');
      for (char& c : text) c = static_cast<char>(random());
    } else if (round % 50 == 1) {
      text.clear();
      for (std::size_t i = below(random, 30); i > 0; --i) text += kPieces[below(random, kPieces.size())];
    }
    for (std::size_t i = below(random, 4) + 1; i > 0; --i) mutate(text, random);
    if (test::checkReader(text)) ++accepted;
  }
  std::printf("%ld rounds, %ld documents accepted and written back\n", rounds, accepted);
  if (accepted * 50 < rounds) {
    std::fprintf(stderr, "Too few mutations stay valid for the round trip to be tested.\n");
    return 1;
  }
  return 0;
}
