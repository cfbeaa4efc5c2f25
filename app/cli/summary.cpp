// `summary FILE... [--jobs N] [-o OUT]`: a row for each file, as CSV.

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <thread>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/load.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/csv.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxJobs = 256;

/// What is told of one file; numbers are empty where the mechanism leaves them undefined.
struct Row {
  std::string status = "unreadable";  ///< "ok", "errors" or "unreadable"
  std::array<std::string, 6> counts;  ///< links, turning joints, meshes, rank, freedom, states
  int errors = 0;
  int warnings = 0;
  std::string codes;  ///< of errors and warnings, each once
  std::string name;
};

void addDiagnostics(Row& row, const Diagnostics& diagnostics) {
  std::vector<std::string_view> codes;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity() == Severity::info) continue;
    (diagnostic.severity() == Severity::error ? row.errors : row.warnings) += 1;
    const std::string_view code = codeName(diagnostic.code);
    if (std::find(codes.begin(), codes.end(), code) == codes.end()) codes.push_back(code);
  }
  for (const std::string_view code : codes) row.codes += (row.codes.empty() ? "" : " ") + std::string(code);
  row.status = row.errors > 0 ? "errors" : "ok";
}

Row rowOf(const std::string& path, const std::stop_token& stop) {
  Row row;
  auto loaded = load(path);
  if (std::holds_alternative<FileError>(loaded)) return row;
  auto& document = std::get<Expected<Mechanism>>(loaded);
  if (!document) {
    addDiagnostics(row, document.error());
    return row;
  }
  const auto mechanism = std::make_shared<const Mechanism>(std::move(document).value());
  SnapshotPtr snapshot = analyzeLive(mechanism, 0, stop);
  if (snapshot) snapshot = analyzeStates(snapshot, {false}, stop);
  if (!snapshot) return row;  // out of time, which the caller tells
  Diagnostics diagnostics = snapshot->diagnostics;
  append(diagnostics, geometryDiagnostics(*snapshot, stop));
  row.name = mechanism->name;
  row.counts = {std::to_string(mechanism->n()), std::to_string(mechanism->t()),
                std::to_string(mechanism->c())};
  if (const MatroidAnalysis* matroid = snapshot->matroid()) {
    row.counts[3] = std::to_string(matroid->rank);
    row.counts[4] = std::to_string(matroid->dof);
  }
  row.counts[5] = std::to_string(mechanism->states.size());
  addDiagnostics(row, diagnostics);
  return row;
}

/// The files named, and of a folder its documents, by name.
std::vector<std::string> filesOf(const std::vector<std::string>& named) {
  std::vector<std::string> files;
  for (const std::string& name : named) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      files.push_back(name);
      continue;
    }
    std::vector<std::string> inside;
    for (const fs::directory_entry& entry : fs::directory_iterator(name, error)) {
      if (entry.path().extension() == ".geargraph") inside.push_back(entry.path().string());
    }
    if (error) files.push_back(name);  // told as unreadable
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

std::string asCsv(const std::vector<std::string>& files, const std::vector<Row>& rows) {
  std::string text =
      "file,status,links,turning joints,gear meshes,rank,freedom,states,errors,warnings,codes,name\n";
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Row& row = rows[i];
    text += csvLabel(files[i], ',') + ',' + row.status;
    for (const std::string& count : row.counts) text += ',' + count;
    text += ',' + std::to_string(row.errors) + ',' + std::to_string(row.warnings) + ',' + row.codes + ',' +
            csvLabel(row.name, ',') + '\n';
  }
  return text;
}

/// Each file on the next thread that is free; the rows are in the order of the files.
std::vector<Row> rowsOf(const std::vector<std::string>& files, int jobs, const std::stop_token& stop) {
  std::vector<Row> rows(files.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < files.size() && !stop.stop_requested(); i = next++)
      rows[i] = rowOf(files[i], stop);
  };
  {
    std::vector<std::jthread> threads;
    for (int job = 1; job < jobs; ++job) threads.emplace_back(work);
    work();
  }
  return rows;
}

int runSummary(const Arguments& arguments) {
  if (arguments.files.empty()) return wrongUsage(kSummary, translated("Files or folders are needed."));
  int jobs = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMaxJobs);
  if (const auto word = arguments.value("--jobs")) {
    const auto given = numberFrom<int>(*word);
    if (!given || *given < 1 || *given > kMaxJobs)
      return wrongUsage(kSummary, translated("--jobs is a whole number from 1 to 256."));
    jobs = *given;
  }
  const std::vector<std::string> files = filesOf(arguments.files);
  const std::vector<Row> rows =
      rowsOf(files, std::min(jobs, std::max(1, static_cast<int>(files.size()))), arguments.stop);
  if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the summary"));
  const int written = writeOutput(asCsv(files, rows), arguments.value("-o").value_or("-"));
  if (written != kFine) return written;
  const auto is = [&](std::string_view status) {
    return std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.status == status; });
  };
  if (is("unreadable")) return kUsageOrFile;
  return is("errors") ? kMechanismErrors : kFine;
}

constexpr std::array kSummaryOptions = {
    Option{"--jobs", "N",
           toTranslate("how many files are analysed at once (as many as there are processors)")},
    Option{"-o", "OUT", toTranslate("the file (standard output without it)")},
};

}  // namespace

const Command kSummary = {"summary",
                          "FILE... [--jobs N] [-o OUT]",
                          toTranslate("A row for each file, or for each document in a folder, as CSV."),
                          kSummaryOptions,
                          runSummary,
                          false,
                          false};

}  // namespace geargraph::cli
