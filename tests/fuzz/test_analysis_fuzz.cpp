// The analysis against whatever the reader accepts: seeded changes of the example trains, mostly of their
// numbers, so that many stay readable and become wrong in every way a drawing can be wrong. It always
// returns; a mechanism without errors has numbers, and both methods agree.

#include <cstdio>
#include <cstdlib>

#include "tests/core/mechanism/document_format/support.h"
#include "tests/core/support/example_files.h"
#include "tests/fuzz/laws.h"
#include "tests/fuzz/mutations.h"

using namespace geargraph;

namespace {

void change(std::string& text, test::Random& random) {
  const std::size_t digit = text.find_first_of("0123456789", test::below(random, text.size()));
  if (test::below(random, 8) == 0 || digit == std::string::npos) {
    test::mutate(text, random);
  } else {
    text[digit] = static_cast<char>('0' + test::below(random, 10));
  }
}

struct Tally {
  long accepted = 0;
  long withNumbers = 0;
};

}  // namespace

int main(int count, char** arguments) {
  const long rounds = count > 1 ? std::atol(arguments[1]) : 1000;
  std::vector<std::string> seeds = {test::kEverything};
  for (const std::string& name : test::exampleNames()) seeds.push_back(test::exampleText(name));

  test::Random random(20240608);
  Tally tally;
  for (long round = 0; round < rounds; ++round) {
    std::string text = seeds[test::below(random, seeds.size())];
    for (std::size_t i = test::below(random, 5) + 1; i > 0; --i) change(text, random);
    const test::Analysed analysed = test::checkAnalysis(text);
    if (analysed != test::Analysed::rejected) ++tally.accepted;
    if (analysed == test::Analysed::withNumbers) ++tally.withNumbers;
  }
  std::printf("%ld rounds, %ld documents accepted, %ld of them with numbers\n", rounds, tally.accepted,
              tally.withNumbers);
  if (tally.accepted * 10 < rounds || tally.withNumbers * 100 < rounds) {
    std::fprintf(stderr, "Too few changes stay readable for this to test anything.\n");
    return 1;
  }
  return 0;
}
