#include "core/design/gearboxes/gearbox_shards.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "core/design/gearboxes/gearbox_json.h"
#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/json_writer.h"

namespace geargraph {
namespace {

constexpr std::string_view kShardFormat = "geargraph-gearbox-shard";
constexpr std::string_view kProgressFormat = "geargraph-gearbox-progress";
constexpr std::int64_t kMaxLayouts = std::int64_t{1} << 40U;

/// FNV-1a, 64 bits: tells wishes apart, and protects against nothing else.
std::string hashOf(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char each : text) {
    hash ^= static_cast<unsigned char>(each);
    hash *= 0x100000001b3U;
  }
  std::string hex(16, '0');
  for (std::size_t i = 0; i < hex.size(); ++i) hex[15 - i] = "0123456789abcdef"[hash >> (4 * i) & 15U];
  return hex;
}

Diagnostic rejectedFile(std::string message) {
  return {Code::format, std::move(message), {}, {}, 0, 0};
}

std::vector<std::int64_t> countsOf(const GearboxSearch& search) {
  return {search.counts.states, search.counts.points,   search.counts.candidates, search.judged.candidates,
          search.judged.teeth,  search.judged.elements, search.judged.limits};
}

void setCounts(GearboxSearch& search, const std::vector<std::int64_t>& counts) {
  search.counts = {counts[0], counts[1], counts[2]};
  search.judged = {counts[3], counts[4], counts[5], counts[6]};
}

std::string numbersText(const std::vector<std::int64_t>& numbers) {
  std::string text = "[";
  for (const std::int64_t each : numbers) text += (text.size() == 1 ? "" : ", ") + std::to_string(each);
  return text + ']';
}

std::optional<std::int64_t> wholeMemberOf(const JsonValue& object, std::string_view name) {
  const auto value = object.is(JsonKind::object) ? object.member(name) : std::nullopt;
  if (!value || !value->is(JsonKind::number)) return std::nullopt;
  const auto exact = Rational::fromText(value->slice());
  if (!exact || !exact->isInteger() || exact->sign() < 0 || *exact > Rational(kMaxLayouts))
    return std::nullopt;
  return static_cast<std::int64_t>(exact->toDouble());
}

std::vector<std::int64_t> wholesMemberOf(const JsonValue& object, std::string_view name) {
  std::vector<std::int64_t> result;
  const auto list = object.is(JsonKind::object) ? object.member(name) : std::nullopt;
  if (!list || !list->is(JsonKind::array)) return result;
  bool isRight = true;
  list->forEachElement([&](JsonValue each, std::size_t) {
    const auto exact = each.is(JsonKind::number) ? Rational::fromText(each.slice()) : std::nullopt;
    isRight = isRight && exact && exact->isInteger() && exact->abs() < Rational(std::int64_t{1} << 53U);
    result.push_back(isRight ? static_cast<std::int64_t>(exact->toDouble()) : 0);
  });
  return isRight ? result : std::vector<std::int64_t>();
}

bool isText(const JsonValue& object, std::string_view name, std::string_view text) {
  const auto value = object.is(JsonKind::object) ? object.member(name) : std::nullopt;
  return value && value->is(JsonKind::string) && value->equals(text);
}

/// Calls visit(line) for each whole line, without its end; what follows the last end of a line is left out.
/// Ends early where visit() returns false.
template <class Visit>
bool forEachLine(std::string_view text, Visit visit) {
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    if (!visit(text.substr(0, end))) return false;
    text.remove_prefix(end + 1);
  }
  return true;
}

std::string manifestOf(const ShardFile& shard) {
  std::string parts = "[";
  for (const int each : shard.parts) parts += (parts.size() == 1 ? "" : ", ") + std::to_string(each);
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject(JsonWriter::Layout::row);
    json.member("format", kShardFormat);
    json.member("version", kSearchVersion);
    json.member("hash", hashOf(shard.canonicalWish));
    json.key("wish");
    json.json(shard.canonicalWish);
    json.key("parts");
    json.json(parts + "]");
    json.member("of", shard.of);
    json.member("layouts", shard.search.layouts);
    json.member("searched", shard.search.searched);
    json.key("counts");
    json.json(numbersText(countsOf(shard.search)));
    json.member("gearboxes", static_cast<std::int64_t>(shard.search.found.size()));
    json.member("seconds", shard.seconds);
    json.endObject();
  }
  return sink.take();
}

/// The layouts of the parts: those of the list whose index is one of them modulo `of`.
std::int64_t layoutsIn(const ShardFile& shard) {
  return std::accumulate(shard.parts.begin(), shard.parts.end(), std::int64_t{0},
                         [&](std::int64_t sum, int part) {
                           return sum + (shard.search.layouts - part + shard.of - 1) / shard.of;
                         });
}

/// False where the manifest is none, or contradicts itself.
bool readManifest(const JsonValue& manifest, ShardFile& shard, std::int64_t& gearboxes) {
  const auto wish = manifest.member("wish");
  const auto of = wholeMemberOf(manifest, "of");
  const auto layouts = wholeMemberOf(manifest, "layouts");
  const auto searched = wholeMemberOf(manifest, "searched");
  const auto found = wholeMemberOf(manifest, "gearboxes");
  const auto counts = wholesMemberOf(manifest, "counts");
  const auto parts = wholesMemberOf(manifest, "parts");
  const auto seconds = manifest.member("seconds");
  if (!wish || !of || *of < 1 || *of > 1'000'000 || !layouts || !searched || !found || counts.size() != 7 ||
      parts.empty() || !seconds || !seconds->is(JsonKind::number))
    return false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] < 0 || parts[i] >= *of || (i > 0 && parts[i] <= parts[i - 1])) return false;
    shard.parts.push_back(static_cast<int>(parts[i]));
  }
  shard.canonicalWish = wish->compact();
  shard.of = static_cast<int>(*of);
  shard.search.layouts = *layouts;
  shard.search.searched = *searched;
  setCounts(shard.search, counts);
  shard.seconds = Rational::fromText(seconds->slice()).value_or(Rational(0)).toDouble();
  gearboxes = *found;
  return isText(manifest, "hash", hashOf(shard.canonicalWish)) && shard.search.searched == layoutsIn(shard);
}

}  // namespace

std::string shardText(const ShardFile& shard) {
  std::string text = manifestOf(shard);
  for (const Gearbox& each : shard.search.found) text += gearboxRecord(each) + '\n';
  return text;
}

Expected<ShardFile> readShard(std::string_view text) {
  ShardFile shard;
  std::int64_t gearboxes = -1;
  std::optional<GearboxWish> wish;
  std::string fault;
  std::int64_t number = 0;
  const bool isWhole = forEachLine(text, [&](std::string_view line) {
    ++number;
    const auto json = JsonDocument::parse(line);
    if (!json) return false;
    const JsonValue value = json->root();
    if (number == 1) {
      if (!isText(value, "format", kShardFormat)) return false;
      const auto version = wholeMemberOf(value, "version");
      if (version != kSearchVersion) {
        fault = translated("It is of another version of the search.");
        return false;
      }
      if (!readManifest(value, shard, gearboxes)) return false;
      auto read = readGearboxWish(shard.canonicalWish);
      if (!read) return false;
      wish = *std::move(read);
      return true;
    }
    auto gearbox = gearboxFromRecord(*wish, value);
    if (!gearbox) return false;
    shard.search.found.push_back(*std::move(gearbox));
    return true;
  });
  if (!fault.empty()) return rejectedFile(fault);
  if (!isWhole || number == 0) {
    return rejectedFile(translated("Line %1 is none of a finished part of a gearbox search.",
                                   {std::to_string(std::max<std::int64_t>(number, 1))}));
  }
  if (gearboxes != static_cast<std::int64_t>(shard.search.found.size()))
    return rejectedFile(translated("The file ends early: its gearboxes are fewer than its first line says."));
  std::sort(shard.search.found.begin(), shard.search.found.end(), ranksBefore);
  shard.search.isComplete = shard.search.layouts == 0 || hasTooFewStates(*wish);
  return shard;
}

Expected<ShardFile> mergedShards(std::vector<ShardFile> shards) {
  GEARGRAPH_REQUIRE(!shards.empty());
  // By their first part, so that the order of the files does not matter.
  std::sort(shards.begin(), shards.end(),
            [](const ShardFile& a, const ShardFile& b) { return a.parts < b.parts; });
  ShardFile all = std::move(shards.front());
  for (std::size_t i = 1; i < shards.size(); ++i) {
    ShardFile& next = shards[i];
    if (next.canonicalWish != all.canonicalWish)
      return rejectedFile(translated("These are parts of searches for different wishes."));
    if (next.of != all.of || next.search.layouts != all.search.layouts) {
      return rejectedFile(translated("These are parts of %1 and of %2: a search is parted once.",
                                     {std::to_string(all.of), std::to_string(next.of)}));
    }
    std::vector<int> common;
    std::set_intersection(all.parts.begin(), all.parts.end(), next.parts.begin(), next.parts.end(),
                          std::back_inserter(common));
    if (common == next.parts) continue;  // all of it is here already
    if (!common.empty()) {
      return rejectedFile(translated("Part %1 is in two files that hold further parts: merge single parts.",
                                     {std::to_string(common.front())}));
    }
    std::vector<int> parts;
    std::merge(all.parts.begin(), all.parts.end(), next.parts.begin(), next.parts.end(),
               std::back_inserter(parts));
    all.parts = std::move(parts);
    all.seconds += next.seconds;
    all.search.add(std::move(next.search));
  }
  std::sort(all.search.found.begin(), all.search.found.end(), ranksBefore);
  return all;
}

std::vector<int> missingParts(const ShardFile& shard) {
  std::vector<int> missing;
  for (int part = 0; part < shard.of; ++part) {
    if (!std::binary_search(shard.parts.begin(), shard.parts.end(), part)) missing.push_back(part);
  }
  return missing;
}

std::string progressHeader(const GearboxWish& wish, const Shard& shard) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject(JsonWriter::Layout::row);
    json.member("format", kProgressFormat);
    json.member("version", kSearchVersion);
    json.member("hash", hashOf(wish.canonical));
    json.member("part", shard.part);
    json.member("of", shard.count);
    json.endObject();
  }
  return sink.take();
}

std::string progressBlock(const GearboxSearch& block, std::int64_t done) {
  std::string text;
  for (const Gearbox& each : block.found) text += gearboxRecord(each) + '\n';
  return text + "{\"done\": " + std::to_string(done) + ", \"layouts\": " + std::to_string(block.layouts) +
         ", \"searched\": " + std::to_string(block.searched) +
         ", \"counts\": " + numbersText(countsOf(block)) + "}\n";
}

Expected<ShardProgress> readProgress(const GearboxWish& wish, const Shard& shard, std::string_view text) {
  ShardProgress progress;
  progress.text = progressHeader(wish, shard);
  if (text.empty() || text.find('\n') == std::string_view::npos) return progress;  // ended at the first line
  if (!text.starts_with(progress.text))
    return rejectedFile(translated("It is of another wish, another part or another version of the search."));
  std::string block;
  GearboxSearch found;
  const bool isWhole = forEachLine(text.substr(progress.text.size()), [&](std::string_view line) {
    const auto json = JsonDocument::parse(line);
    if (!json) return false;
    const JsonValue value = json->root();
    block += line;
    block += '\n';
    const auto done = wholeMemberOf(value, "done");
    if (!done) {
      auto gearbox = gearboxFromRecord(wish, value);
      if (!gearbox) return false;
      found.found.push_back(*std::move(gearbox));
      return true;
    }
    const auto layouts = wholeMemberOf(value, "layouts");
    const auto searched = wholeMemberOf(value, "searched");
    const auto counts = wholesMemberOf(value, "counts");
    if (!layouts || !searched || counts.size() != 7) return false;
    found.searched = *searched;
    setCounts(found, counts);
    progress.search.layouts = *layouts;
    progress.search.add(std::move(found));
    progress.done = *done;
    progress.text += block;
    found = {};
    block.clear();
    return true;
  });
  if (!isWhole) return rejectedFile(translated("It holds a line that is none of this search."));
  return progress;
}

}  // namespace geargraph
