// The reader against hostile bytes: seeded mutations of valid files, and random bytes. Whatever comes, it
// returns; what it accepts round-trips to the same value and the same bytes; and it takes for JSON exactly
// what an independent reader (nlohmann's) takes for JSON, apart from its own limits.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "core/io/json.h"
#include "core/mechanism/validate.h"
#include "tests/core/io/support.h"
#include "tests/core/support/example_files.h"
#include "tests/fuzz/mutations.h"

using namespace geargraph;
using test::below;
using test::kPieces;
using test::mutate;
using test::Random;

namespace {

[[noreturn]] void fail(const char* what, const std::string& text) {
  std::fprintf(stderr, "%s, for these %zu bytes:\n", what, text.size());
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::exit(1);
}

void checkJsonAgainstOther(const std::string& text) {
  if (text.find('\0') != std::string::npos) return;  // for nlohmann's reader a text ends there
  const auto ours = JsonDocument::parse(text);
  if (!ours && ours.error().front().code == Code::schema) return;  // nested too deeply
  // nlohmann refuses numbers beyond a double as a parse error; for us they are JSON, refused later.
  bool outOfRange = false;
  bool theirs = true;
  try {
    theirs = !nlohmann::json::parse(text).is_discarded();
  } catch (const nlohmann::json::out_of_range&) {
    outOfRange = true;
  } catch (const nlohmann::json::exception&) {
    theirs = false;
  }
  if (!outOfRange && ours.has_value() != theirs) fail("Another reader judges the JSON differently", text);
}

void checkReader(const std::string& text, long& accepted) {
  const auto first = readMechanism(text);
  if (!first) {
    for (const Diagnostic& diagnostic : first.error()) {
      if (diagnostic.message.empty() || diagnostic.severity() != Severity::error)
        fail("A finding says nothing", text);
    }
    return;
  }
  ++accepted;
  if (!wellFormedDiagnostics(*first).empty()) fail("Accepted, but not well formed", text);
  (void)treeDiagnostics(*first);
  const std::string written = writeMechanism(*first);
  const auto second = readMechanism(written);
  if (!second) fail("What was written is not read", text);
  if (!(*second == *first)) fail("What was written reads as another document", text);
  if (writeMechanism(*second) != written) fail("Writing is not canonical", text);
}

}  // namespace

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
    checkJsonAgainstOther(text);
    checkReader(text, accepted);
  }
  std::printf("%ld rounds, %ld documents accepted and written back\n", rounds, accepted);
  if (accepted * 50 < rounds) {
    std::fprintf(stderr, "Too few mutations stay valid for the round trip to be tested.\n");
    return 1;
  }
  return 0;
}
