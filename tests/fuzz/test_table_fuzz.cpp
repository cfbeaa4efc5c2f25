// The reader of tables against hostile bytes: seeded mutations of the tables of all examples, and random
// bytes.

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "core/mechanism/document_format/mechanism_table.h"
#include "tests/core/mechanism/document_format/support.h"
#include "tests/core/support/example_files.h"
#include "tests/fuzz/laws.h"
#include "tests/fuzz/mutations.h"

using namespace geargraph;
using test::below;
using test::Random;

namespace {

const std::vector<std::string> kTablePieces = {
    ",",    ";",      "\t",  "\n",    "\r\n",  "\"",      "\"\"",   "'",         "'=",    "|",
    "\\",   "1/2",    "-",   "1e999", "1,5",   "\xFF",    "link",   "axis",      "input", "brake",
    "load", "clutch", "yes", "bevel", "99999", "element", "state,", "balance\n", ",,,",   "\xEF\xBB\xBF"};

std::vector<std::string> seeds() {
  std::vector<std::string> tables = {"element,id\nlink,0\n",
                                     writeMechanismTable(*readMechanism(test::kEverything))};
  for (const std::string& name : test::exampleNames()) {
    const char separator = ",;\t"[tables.size() % 3];
    tables.push_back(writeMechanismTable(test::example(name), {separator, false}));
  }
  return tables;
}

}  // namespace

int main(int count, char** arguments) {
  const long rounds = count > 1 ? std::atol(arguments[1]) : 1000;
  const std::vector<std::string> tables = seeds();
  Random random(20261125);
  long accepted = 0;
  for (long round = 0; round < rounds; ++round) {
    std::string text = tables[below(random, tables.size())];
    if (round % 50 == 0) {
      text.assign(below(random, 200), '\0');
      for (char& c : text) c = static_cast<char>(random());
    } else if (round % 50 == 1) {
      text = "element,id,name,engaged\n";
      for (std::size_t i = below(random, 30); i > 0; --i)
        text += kTablePieces[below(random, kTablePieces.size())];
    }
    for (std::size_t i = below(random, 3) + 1; i > 0; --i) {
      if (below(random, 2) == 0) {
        test::mutate(text, random);
      } else {
        text.insert(below(random, text.size() + 1), kTablePieces[below(random, kTablePieces.size())]);
      }
    }
    if (test::checkTable(text)) ++accepted;
  }
  std::printf("%ld rounds, %ld tables read and written back\n", rounds, accepted);
  if (accepted * 50 < rounds) {
    std::fprintf(stderr, "Too few mutations stay valid for the round trip to be tested.\n");
    return 1;
  }
  return 0;
}
