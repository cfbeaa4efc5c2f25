#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/design/gearboxes/gearbox_run.h"
#include "core/foundations/base/expected.h"

namespace geargraph {

/// Raised whenever the same wish is answered by other bytes: files of different searches are not merged.
constexpr int kSearchVersion = 1;

/// A finished part of a search, or several of the same list: what one task of a cluster leaves.
struct ShardFile {
  std::string canonicalWish;
  std::vector<int> parts;  ///< ascending, of `of`
  int of = 1;
  GearboxSearch search;
  double seconds = 0;  ///< processor time, all parts
};

/// JSON Lines: a manifest, then a record for each gearbox (gearboxRecord()).
[[nodiscard]] std::string shardText(const ShardFile& shard);
/// Reads shardText() and computes each gearbox anew from its record. Rejects `format` for other files and
/// versions, or where the hash of the wish or a count differs from the manifest.
[[nodiscard]] Expected<ShardFile> readShard(std::string_view text);

/// All parts in one; parts that are given twice count once. Rejects `format` for parts of different wishes or
/// different numbers of parts. Associative: merging merged files gives the same.
[[nodiscard]] Expected<ShardFile> mergedShards(std::vector<ShardFile> shards);
/// The parts that are missing, ascending. Where there are none the counts of layouts add up to the whole
/// list.
[[nodiscard]] std::vector<int> missingParts(const ShardFile& shard);

/// What is written while a part is searched: a header, then for each block its records and a line that says
/// how far it goes.
[[nodiscard]] std::string progressHeader(const GearboxWish& wish, const Shard& shard);
[[nodiscard]] std::string progressBlock(const GearboxSearch& block, std::int64_t done);

/// What such a file holds up to its last whole block.
struct ShardProgress {
  std::string text;  ///< of these blocks, with the header
  std::int64_t done = 0;
  GearboxSearch search;
};
/// Rejects `format` for the progress of another wish, version or part.
[[nodiscard]] Expected<ShardProgress> readProgress(const GearboxWish& wish, const Shard& shard,
                                                   std::string_view text);

}  // namespace geargraph
