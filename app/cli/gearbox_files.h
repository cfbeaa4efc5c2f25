#pragma once

#include <iostream>
#include <string>
#include <variant>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "core/design/gearboxes/gearbox_run.h"
#include "core/foundations/base/expected.h"
#include "core/foundations/files/file.h"

namespace geargraph::cli {

constexpr std::size_t kLargestWish = std::size_t{1024} * 1024;

/// Reads a wish with `read(json)`. On failure it reports the reason on standard error and returns the exit
/// status.
template <class Wish>
[[nodiscard]] std::variant<Wish, int> readWishOrSay(const std::string& path,
                                                    Expected<Wish> (*read)(std::string_view)) {
  const auto text = readFile(path, kLargestWish);
  if (const auto* error = std::get_if<FileError>(&text)) return fileFailure(error->message);
  Expected<Wish> wish = read(std::get<std::string>(text));
  if (wish) return *std::move(wish);
  std::cerr << diagnosticLines(path, wish.error());
  return kUsageOrFile;
}

/// The threads of `--jobs`; all processors but one without it.
[[nodiscard]] std::variant<int, UsageError> jobsFrom(const Arguments& arguments);
/// "3/8": the fourth of eight parts.
[[nodiscard]] std::optional<Shard> shardFrom(std::string_view text);

/// Reports on standard error how far a search is, twenty times at most.
class SearchProgress {
 public:
  void operator()(std::int64_t done, std::int64_t total, std::size_t found);

 private:
  std::int64_t m_steps = 0;
};

/// `gearbox WISH --shard R/N [--resume] -o FILE`: searches one part of the layouts into a file of JSON Lines.
/// While it runs, and after it was stopped, what is done is in FILE.part. Returns the exit status.
int searchShard(const Arguments& arguments, const GearboxWish& wish, const Shard& shard, int threads);

/// The parts of a search in files, merged. On failure it reports the reason and returns the exit status.
struct MergedSearch {
  GearboxWish wish;
  GearboxSearch search;
};
/// `gearbox merge FILES...`; with `--parts FILE` the merged parts are written there, and may be some.
[[nodiscard]] std::variant<MergedSearch, int> mergeOrSay(const Arguments& arguments);

}  // namespace geargraph::cli
