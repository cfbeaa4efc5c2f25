// The readers of graphs against hostile bytes: seeded mutations of the graphs of all examples in every form,
// and random bytes.

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "core/mechanism/document_format/mechanism_graph.h"
#include "tests/core/mechanism/document_format/support.h"
#include "tests/core/support/example_files.h"
#include "tests/fuzz/laws.h"
#include "tests/fuzz/mutations.h"

using namespace geargraph;
using test::below;
using test::Random;

namespace {

const std::vector<std::string> kGraphPieces = {
    "{",          "}",           "[",        "]",         ";",          ",",
    "=",          "->",          "--",       ":",         "+",          "\"",
    "\\\"",       "<",           ">",        "<!--",      "]]>",        "<![CDATA[",
    "&lt;",       "&#0;",        "&a;",      "/*",        "*/",         "//",
    "#",          "\n",          "subgraph", "strict ",   "node",       "edge",
    "graph ",     "digraph ",    "<graph>",  "<node>",    "</node>",    "<edge>",
    "<data>",     "</data>",     "-1.5",     "1e999",     "22/7",       "null",
    "\"nodes\":", "\"links\":",  "\"id\":0", "kind=mesh", "axis=\"a\"", "directed='false'",
    "\xFF",       "\xEF\xBB\xBF"};

std::vector<std::string> seeds() {
  std::vector<Mechanism> mechanisms = {emptyMechanism(), *readMechanism(test::kEverything)};
  for (const std::string& name : test::exampleNames()) mechanisms.push_back(test::example(name));
  std::vector<std::string> texts = {"digraph { a -> b [kind=turning, axis=x] }"};
  for (const Mechanism& mechanism : mechanisms) {
    for (const GraphForm form : {GraphForm::dot, GraphForm::graphMl, GraphForm::nodeLink})
      texts.push_back(digraphFile(mechanism, form));
  }
  return texts;
}

}  // namespace

int main(int count, char** arguments) {
  const long rounds = count > 1 ? std::atol(arguments[1]) : 1000;
  const std::vector<std::string> texts = seeds();
  Random random(20261126);
  long accepted = 0;
  for (long round = 0; round < rounds; ++round) {
    std::string text = texts[below(random, texts.size())];
    if (round % 50 == 0) {
      text.assign(below(random, 200), '\0');
      for (char& c : text) c = static_cast<char>(random());
    } else if (round % 50 == 1) {
      text = "digraph {";
      for (std::size_t i = below(random, 30); i > 0; --i)
        text += kGraphPieces[below(random, kGraphPieces.size())] + ' ';
    }
    for (std::size_t i = below(random, 3) + 1; i > 0; --i) {
      if (below(random, 2) == 0) {
        test::mutate(text, random);
      } else {
        text.insert(below(random, text.size() + 1), kGraphPieces[below(random, kGraphPieces.size())]);
      }
    }
    if (test::checkGraph(text)) ++accepted;
  }
  std::printf("%ld rounds, %ld graphs read and written back\n", rounds, accepted);
  if (accepted * 50 < rounds) {
    std::fprintf(stderr, "Too few mutations stay valid for the round trip to be tested.\n");
    return 1;
  }
  return 0;
}
