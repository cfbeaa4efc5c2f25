#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/presentation/exporters/exporters.h"
#include "tests/fuzz/laws.h"

namespace geargraph::test {
namespace {

enum class Output { json, text, bytes };

/// Among the words of a case: the document, and a paper for `check`.
constexpr std::string_view kDocument = "DOCUMENT", kPaper = "PAPER";

struct Case {
  const cli::Command* command;
  Output output;
  std::vector<std::string> words;  ///< kDocument is the first where it is not among them
};

/// Papers of all forms: equations right and wrong, and tables of the size of a matrix of small trains.
constexpr std::array<std::string_view, 6> kPapers = {"w21 = -N5/N2 w51\nw10 = 2 w20\n",
                                                     "w30 = w10\n",
                                                     "1 0\n0 1\n",
                                                     "1,0,0\n0,1,0\n0,0,1\n1,1,1\n",
                                                     "C,1,2,3,4,5\nC4,1,0,-1,1,0\nC5,0,1,-1,0,1\n",
                                                     "S,3\n1,1/2\n2,-2\n"};

/// Commands with options; new ones are appended, since the inputs of the corpus name them by position.
const std::vector<Case>& commandCases() {
  const auto exported = [](Output output, std::vector<std::string> words) {
    words.insert(words.begin(), "--to");
    words.insert(words.end(), {"-o", "-"});
    return Case{&cli::kExport, output, std::move(words)};
  };
  static const std::vector<Case> kCases = {
      {&cli::kAnalyze, Output::json, {"--json"}},
      {&cli::kAnalyze, Output::text, {}},
      {&cli::kValidate, Output::json, {"--json"}},
      {&cli::kInputs, Output::json, {"--json", "--limit", "20"}},
      {&cli::kStates, Output::json, {"--json"}},
      {&cli::kLevers, Output::json, {"--json"}},
      {&cli::kPose, Output::json, {"--json"}},
      exported(Output::text, {"csv", "--matrix", "p"}),
      exported(Output::text, {"csv", "--matrix", "solution"}),
      exported(Output::text, {"csv", "--matrix", "screw"}),
      exported(Output::text, {"html"}),
      exported(Output::text, {"latex"}),
      exported(Output::text, {"md"}),
      exported(Output::bytes, {"pdf"}),
      exported(Output::text, {"svg", "--view", "digraph"}),
      exported(Output::text, {"svg", "--view", "ttgraph"}),
      exported(Output::text, {"svg", "--view", "schematic"}),
      exported(Output::bytes, {"png", "--view", "schematic"}),
      exported(Output::bytes, {"pdf", "--view", "digraph"}),
      exported(Output::text, {"dot", "--view", "ttgraph"}),
      exported(Output::text, {"graphml"}),
      exported(Output::json, {"node-link"}),
      exported(Output::bytes, {"stl", "--tolerance", "0.2"}),
      exported(Output::text, {"obj", "--tolerance", "0.2"}),
      exported(Output::bytes, {"ply", "--tolerance", "0.2"}),
      exported(Output::bytes, {"glb", "--tolerance", "0.2"}),
      exported(Output::bytes, {"3mf", "--tolerance", "0.2"}),
      {&cli::kStatics, Output::json, {"--json"}},
      {&cli::kStatics, Output::text, {"--efficiency", "--share", "stiffness"}},
      {&cli::kStatics, Output::text, {"--all-states"}},
      {&cli::kDynamics, Output::json, {"--json"}},
      exported(Output::text, {"csv", "--matrix", "tt-circuit"}),
      exported(Output::bytes, {"handout"}),  // whose scripts hold any word
      exported(Output::bytes, {"handout", "--exercises", "--seed", "1"}),
      exported(Output::text, {"modelica"}),
      exported(Output::json, {"node-link", "--view", "ttgraph"}),
      {&cli::kConvert, Output::text, {"--to", "csv"}},
      {&cli::kConvert, Output::text, {"--to", "graphml"}},
      {&cli::kSummary, Output::text, {}},
      {&cli::kExercises, Output::text, {"kinds", std::string(kDocument)}},
      {&cli::kCheck, Output::json, {std::string(kDocument), std::string(kPaper), "--json"}},
      {&cli::kCheck, Output::text, {std::string(kDocument), std::string(kPaper)}},
      {&cli::kCheck, Output::text, {std::string(kDocument), std::string(kPaper), "--matrix", "solution"}},
  };
  return kCases;
}

/// The words of an exporter for standard output, with what it needs, coarse and small.
Case caseOf(const Exporter& exporter) {
  std::vector<std::string> words{"--to", std::string(exporter.form)};
  const auto add = [&](std::string_view name, std::string_view value) {
    words.emplace_back(name);
    if (!value.empty()) words.emplace_back(value);
  };
  for (const auto& [name, value] : exporter.implied) add(name, value);
  for (const ExportOption& option : exporter.options) {
    if (option.isNeeded) add(option.name, option.choices().front());
    if (option.name == "--tolerance") add(option.name, "0.2");
    if (option.name == "--size") add(option.name, "64x48");
    if (option.name == "--frames") add(option.name, "2");
  }
  words.insert(words.end(), {"-o", "-"});
  return {&cli::kExport, exporter.suffix == "json" ? Output::json : Output::bytes, std::move(words)};
}

/// Those above, then every exporter that writes a stream.
const std::vector<Case>& cases() {
  static const std::vector<Case> kCases = [] {
    std::vector<Case> all = commandCases();
    for (const Exporter* exporter : allExporters()) {
      if (exporter->files != ExportFiles::folder) all.push_back(caseOf(*exporter));
    }
    return all;
  }();
  return kCases;
}

bool isLarge(const Mechanism& mechanism) {
  constexpr int kMaxLinks = 40, kMaxTeeth = 3000;
  long teeth = 0;
  for (const GearMesh& mesh : mechanism.gearMeshes) teeth += mesh.tailTeeth + mesh.headTeeth;
  return mechanism.links.size() > kMaxLinks || teeth > kMaxTeeth;
}

/// A file in memory in place of a descriptor, whose contents can be read again and again.
class MemoryFile {
 public:
  MemoryFile() : m_descriptor(::memfd_create("geargraph-fuzz", 0)) {
    if (m_descriptor < 0) lawFailed("There is no memory for a file", {});
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { ::close(m_descriptor); }

  void standFor(int descriptor) const { ::dup2(m_descriptor, descriptor); }
  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(m_descriptor); }
  void put(std::string_view bytes) const {
    clear();
    if (::pwrite(m_descriptor, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
      lawFailed("The memory for a file does not suffice", bytes);
  }
  void clear() const {
    if (::ftruncate(m_descriptor, 0) != 0 || ::lseek(m_descriptor, 0, SEEK_SET) != 0)
      lawFailed("The file in memory cannot be cut", {});
  }
  [[nodiscard]] std::string contents() const {
    std::string bytes(static_cast<std::size_t>(::lseek(m_descriptor, 0, SEEK_END)), '\0');
    if (::pread(m_descriptor, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
      lawFailed("The file in memory cannot be read", {});
    return bytes;
  }

 private:
  int m_descriptor;
};

/// "nan" or "inf" as a word of its own, whatever its sign.
bool hasNonFiniteNumber(std::string_view text) {
  const auto isLetter = [&](std::size_t at) {
    return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
  };
  for (const std::string_view word : {"nan", "inf"}) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
      if ((at == 0 || !isLetter(at - 1)) && !isLetter(at + word.size())) return true;
    }
  }
  return false;
}

std::vector<std::string> wordsOf(const Case& chosen, const std::string& document, const std::string& paper) {
  std::vector<std::string> words = chosen.words;
  if (std::find(words.begin(), words.end(), kDocument) == words.end())
    words.insert(words.begin(), std::string(kDocument));
  std::replace(words.begin(), words.end(), std::string(kDocument), document);
  std::replace(words.begin(), words.end(), std::string(kPaper), paper);
  return words;
}

}  // namespace

void checkExports(const std::string& input) {
  if (input.empty()) return;
  const std::string document = input.substr(1);
  const auto read = readMechanism(document);
  if (!read || isLarge(*read)) return;
  // The inputs of the corpus begin with '*', which is the first case.
  const std::size_t number = static_cast<unsigned char>(input.front()) + 256U - '*';
  const Case& chosen = cases()[number % 256 % cases().size()];

  static const MemoryFile file, paper, output;
  static const bool isQuiet = [] {
    output.standFor(STDOUT_FILENO);
    std::cerr.rdbuf(nullptr);
    return true;
  }();
  file.put(document);
  paper.put(kPapers[document.size() % kPapers.size()]);
  output.clear();
  const auto arguments =
      cli::parseArguments(wordsOf(chosen, file.path(), paper.path()), chosen.command->options);
  if (!isQuiet || std::holds_alternative<cli::UsageError>(arguments)) lawFailed("A wrong case", input);
  const int status = chosen.command->run(std::get<cli::Arguments>(arguments));
  const std::string bytes = output.contents();

  if (status < cli::kFine || status > cli::kResourceLimit)
    lawFailed("A status that is not documented", input);
  if (status == cli::kFine && bytes.empty()) lawFailed("Nothing was written", input);
  if (chosen.output == Output::json && !bytes.empty() && !nlohmann::json::accept(bytes))
    lawFailed("What is called JSON is none", input);
  // Names of the document may hold these words; escaped ones do not count as names.
  if (chosen.output != Output::bytes && !hasNonFiniteNumber(document) && hasNonFiniteNumber(bytes))
    lawFailed("A number is not finite", input);
}

}  // namespace geargraph::test
