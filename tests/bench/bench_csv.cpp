// The path matrix Z of 10,000 links and the coefficient matrix P of 30,000 as CSV, against write() of the
// same bytes to the same disk in the same run.
//
// accept  at most 1.25 times the time of write() for a local tree and 1.6 for a deep one; 2.5 for the worst
// there is,
//         a deep tree whose links are numbered at random, where half of all fields are scattered non-zeros;
//         of P 3 times the time of write()

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <vector>

#include "core/foundations/base/contract.h"
#include "core/foundations/files/file.h"
#include "core/foundations/files/matrix_csv.h"
#include "core/mechanism/graph/matrices.h"
#include "core/teaching/derivation/named_results.h"
#include "tests/bench/families.h"

namespace geargraph {
namespace {

constexpr int kLinks = 10'000;

constexpr int kManyLinks = 30'000;

enum class Family { local, deep, shuffled, coefficients };

/// The same mechanism with its links in another order: a file that grew without a plan.
Mechanism withLinksShuffled(Mechanism mechanism) {
  std::mt19937_64 random(11);
  auto& links = mechanism.links;
  for (std::size_t i = links.size() - 1; i > 1; --i) std::swap(links[i], links[random() % i + 1]);
  return mechanism;
}

Mechanism trainOf(Family family) {
  if (family == Family::local) return bench::epicyclicTree(kLinks);
  const Mechanism deep = bench::nestedCarriers(kLinks);
  return family == Family::deep ? deep : withLinksShuffled(deep);
}

struct Case {
  IntegerMatrixPtr matrix;
  ResultTablePtr quantity;  ///< in its place for P
  std::string bytes;        ///< its CSV; of P, which has 1.8 GB, its first part
  std::size_t size = 0;     ///< of the whole CSV

  void writeTo(ByteSink& sink) const {
    if (matrix) return writeMatrixCsv<MatrixEntry, UniformRow>(sink, *matrix);
    std::vector<std::string> columns;
    for (int column = 0; column < quantity->columns(); ++column)
      columns.push_back(quantity->columnHeading(column).text);
    CsvWriter csv(sink, columns, {});
    for (int row = 0; row < quantity->rows(); ++row) {
      const std::vector<ResultEntry> entries = quantity->row(row);
      csv.sparseRow(quantity->rowHeading(row).text, std::span<const ResultEntry>(entries));
    }
  }
};

/// Counts bytes, and keeps the first of them.
class FirstBytes final : public ByteSink {
 public:
  void write(std::string_view bytes) override {
    constexpr std::size_t kMax = std::size_t{1} << 28U;
    m_size += bytes.size();
    if (m_text.size() < kMax) m_text += bytes;
  }
  [[nodiscard]] std::size_t size() const { return m_size; }
  [[nodiscard]] std::string take() { return std::move(m_text); }

 private:
  std::string m_text;
  std::size_t m_size = 0;
};

const Case& caseOf(Family family) {
  static std::map<Family, Case> cases;
  auto [place, isNew] = cases.try_emplace(family);
  if (isNew && family == Family::coefficients) {
    const SnapshotPtr snapshot =
        analyzeLive(std::make_shared<const Mechanism>(bench::epicyclicTree(kManyLinks)));
    place->second.quantity = resultTable(*resultNamed("p"), {snapshot}, EntryForm::fractions);
  } else if (isNew) {
    const auto graph = std::make_shared<const Digraph>(trainOf(family));
    const auto tree = SpanningTree::of(*graph);
    GEARGRAPH_REQUIRE(tree.has_value());
    place->second.matrix = pathMatrix(graph, std::make_shared<const SpanningTree>(*tree));
  }
  if (isNew) {
    FirstBytes sink;
    place->second.writeTo(sink);
    place->second.size = sink.size();
    place->second.bytes = sink.take();
  }
  return place->second;
}

/// A new file for each round, gone afterwards.
class ScratchFile {
 public:
  ScratchFile() : m_descriptor(::open(path().c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600)) {
    GEARGRAPH_REQUIRE(m_descriptor >= 0);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    ::close(m_descriptor);
    ::unlink(path().c_str());
  }
  [[nodiscard]] int descriptor() const { return m_descriptor; }

 private:
  static std::string path() {
    return (std::filesystem::temp_directory_path() / ("bench_csv." + std::to_string(::getpid()))).string();
  }
  int m_descriptor;
};

class DescriptorSink final : public ByteSink {
 public:
  explicit DescriptorSink(int descriptor) : m_descriptor(descriptor) {}
  void write(std::string_view bytes) override {
    while (!bytes.empty() && !m_failed) {
      const ssize_t written = ::write(m_descriptor, bytes.data(), bytes.size());
      m_failed = written < 0;
      if (!m_failed) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  [[nodiscard]] bool failed() const override { return m_failed; }

 private:
  int m_descriptor;
  bool m_failed = false;
};

void rawWrite(benchmark::State& state, Family family) {
  const auto& [matrix, quantity, bytes, size] = caseOf(family);
  constexpr std::size_t kPiece = std::size_t{1} << 18U;  // as CsvWriter's
  for (auto _ : state) {
    const ScratchFile file;
    DescriptorSink sink(file.descriptor());
    for (std::size_t at = 0; at < size; at += kPiece) {
      const std::size_t place = at % bytes.size();  // the first bytes again and again
      sink.write(std::string_view(bytes).substr(place, std::min(kPiece, size - at)));
    }
    GEARGRAPH_REQUIRE(!sink.failed());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(size) * state.iterations());
}

void csv(benchmark::State& state, Family family) {
  const Case& matrix = caseOf(family);
  for (auto _ : state) {
    const ScratchFile file;
    DescriptorSink sink(file.descriptor());
    matrix.writeTo(sink);
    GEARGRAPH_REQUIRE(!sink.failed());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(matrix.size) * state.iterations());
}

/// Keeps the shortest time of each benchmark: what disturbs on a shared machine only ever adds.
class ShortestTimes final : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const auto [place, isNew] = m_times.try_emplace(run.run_name.function_name, run.GetAdjustedRealTime());
      if (!isNew) place->second = std::min(place->second, run.GetAdjustedRealTime());
    }
    ConsoleReporter::ReportRuns(runs);
  }
  [[nodiscard]] double of(const std::string& name) const { return m_times.at(name); }

 private:
  std::map<std::string, double> m_times;
};

struct Claim {
  const char* name;
  const char* what;
  Family family;
  double accept;  ///< times the time of write()
};
constexpr std::array kClaims = {Claim{"local_tree", "Z, 10,000 links", Family::local, 1.25},
                                Claim{"deep_tree", "Z, 10,000 links", Family::deep, 1.6},
                                Claim{"deep_shuffled", "Z, 10,000 links", Family::shuffled, 2.5},
                                Claim{"coefficients", "P, 30,000 links", Family::coefficients, 3}};

}  // namespace
}  // namespace geargraph

int main(int count, char** arguments) {
  using namespace geargraph;
  for (const Claim& claim : kClaims) {
    const auto add = [&](const std::string& kind, void (*function)(benchmark::State&, Family)) {
      benchmark::RegisterBenchmark((kind + claim.name).c_str(), function, claim.family)
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime()
          ->Iterations(1)
          ->Repetitions(claim.family == Family::coefficients ? 3 : 7);
    };
    add("write/", rawWrite);
    add("csv/", csv);
  }
  // Rounds of all in turn, so that what disturbs the machine for a while disturbs both sides of a ratio.
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> words(arguments, arguments + count);
  words.insert(words.begin() + 1, interleave.data());
  int wordCount = static_cast<int>(words.size());
  benchmark::Initialize(&wordCount, words.data());
  ShortestTimes times;
  benchmark::RunSpecifiedBenchmarks(&times);
  bool isSlow = false;
  for (const Claim& claim : kClaims) {
    const double ratio =
        times.of(std::string("csv/") + claim.name) / times.of(std::string("write/") + claim.name);
    std::printf("CSV of %s, %-15s %.2f times write() (accepted: %.2f)\n", claim.what, claim.name, ratio,
                claim.accept);
    isSlow = isSlow || ratio > 1.5 * claim.accept;  // half as much again is left to a busy machine
  }
  return isSlow ? EXIT_FAILURE : EXIT_SUCCESS;
}
