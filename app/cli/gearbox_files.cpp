#include "app/cli/gearbox_files.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "app/cli/time_limit.h"
#include "core/design/gearboxes/gearbox_shards.h"
#include "core/foundations/base/translation.h"

namespace geargraph::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxSearchJobs = 256;
constexpr int kMaxShards = 1'000'000;
constexpr std::size_t kLargestShard = std::size_t{1} << 30U;

int badPart(const std::string& path, const Diagnostics& why) {
  return fileFailure(path + ": " + why.front().message);
}

/// Appends text to a file, so that a process that is killed leaves whole blocks.
bool appendTo(std::ofstream& file, const std::string& text) {
  file << text << std::flush;
  return file.good();
}

}  // namespace

std::variant<int, UsageError> jobsFrom(const Arguments& arguments) {
  const auto word = arguments.value("--jobs");
  if (!word) return std::clamp(static_cast<int>(std::thread::hardware_concurrency()) - 1, 1, kMaxSearchJobs);
  const auto given = numberFrom<int>(*word);
  if (given && *given >= 1 && *given <= kMaxSearchJobs) return *given;
  return UsageError{translated("--jobs is a whole number from 1 to 256.")};
}

std::optional<Shard> shardFrom(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto part = numberFrom<int>(text.substr(0, slash));
  const auto count = numberFrom<int>(text.substr(slash + 1));
  if (!part || !count || *count < 1 || *count > kMaxShards || *part < 0 || *part >= *count)
    return std::nullopt;
  return Shard{*part, *count};
}

void SearchProgress::operator()(std::int64_t done, std::int64_t total, std::size_t found) {
  constexpr std::int64_t kSteps = 20;
  const std::int64_t step = total == 0 ? kSteps : done * kSteps / total;
  if (step == m_steps || step == kSteps) return;
  m_steps = step;
  std::cerr << translated("%1 of %2 layouts, %3 found",
                          {std::to_string(done), std::to_string(total), std::to_string(found)})
            << std::endl;
}

int searchShard(const Arguments& arguments, const GearboxWish& wish, const Shard& shard, int threads) {
  const std::string path = arguments.value("-o").value();
  const bool isResumed = arguments.has("--resume");
  std::error_code ignored;
  if (isResumed && fs::exists(path, ignored)) return kFine;  // finished before
  const std::string partPath = path + ".part";
  ShardProgress progress;
  progress.text = progressHeader(wish, shard);
  if (isResumed && fs::exists(partPath, ignored)) {
    const auto text = readFile(partPath, kLargestShard);
    if (const auto* error = std::get_if<FileError>(&text)) return fileFailure(error->message);
    auto read = readProgress(wish, shard, std::get<std::string>(text));
    if (!read) return badPart(partPath, read.error());
    progress = *std::move(read);
  }
  std::ofstream file(partPath, std::ios::binary | std::ios::trunc);
  if (!appendTo(file, progress.text)) return fileFailure(translated("%1 could not be written.", {partPath}));

  GearboxRunOptions options;
  options.shard = shard;
  options.from = progress.done;
  options.threads = threads;
  SearchProgress say;
  std::size_t found = progress.search.found.size();
  bool isWritten = true;
  options.onBlock = [&](const GearboxSearch& block, std::int64_t done, std::int64_t total) {
    isWritten = appendTo(file, progressBlock(block, done));
    found += block.found.size();
    say(done, total, found);
    return isWritten;
  };
  const std::clock_t start = std::clock();
  auto search = findGearboxes(wish, options, arguments.stop);
  if (!isWritten) return fileFailure(translated("%1 could not be written.", {partPath}));
  if (!search) return outOfTime(arguments, translated("the search"));
  search->searched += progress.search.searched;
  search->counts += progress.search.counts;
  search->judged += progress.search.judged;
  std::move(progress.search.found.begin(), progress.search.found.end(), std::back_inserter(search->found));
  std::sort(search->found.begin(), search->found.end(), ranksBefore);
  ShardFile result;
  result.canonicalWish = wish.canonical;
  result.parts = {shard.part};
  result.of = shard.count;
  result.search = *std::move(search);
  result.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (const auto failure = writeFile(path, shardText(result))) return fileFailure(failure->message);
  file.close();
  fs::remove(partPath, ignored);
  return kFine;
}

std::variant<MergedSearch, int> mergeOrSay(const Arguments& arguments) {
  std::vector<ShardFile> shards;
  for (const std::string& path : arguments.files) {
    const auto text = readFile(path, kLargestShard);
    if (const auto* error = std::get_if<FileError>(&text)) return fileFailure(error->message);
    auto shard = readShard(std::get<std::string>(text));
    if (!shard) return badPart(path, shard.error());
    shards.push_back(*std::move(shard));
  }
  auto merged = mergedShards(std::move(shards));
  if (!merged) return fileFailure(merged.error().front().message);
  if (const auto out = arguments.value("--parts")) {
    if (const auto failure = writeFile(*out, shardText(*merged))) return fileFailure(failure->message);
    return kFine;
  }
  const std::vector<int> missing = missingParts(*merged);
  if (!missing.empty()) {
    return fileFailure(translated(
        "%1 of %2 parts are missing, the first is %3/%2.",
        {std::to_string(missing.size()), std::to_string(merged->of), std::to_string(missing.front())}));
  }
  auto wish = readGearboxWish(merged->canonicalWish);
  if (!wish) return badPart(arguments.files.front(), wish.error());
  ShardFile whole = *std::move(merged);
  return MergedSearch{*std::move(wish), std::move(whole.search)};
}

}  // namespace geargraph::cli
