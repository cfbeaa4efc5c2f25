#include "core/design/teeth_search/teeth_json.h"

#include "core/foundations/files/json_writer.h"

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

void writeTeethOf(JsonWriter& json, const Mechanism& train, const std::vector<MeshTeeth>& teeth) {
  json.beginObject(Layout::row);
  for (const MeshTeeth& each : teeth) {
    json.key(std::to_string(train.meshLabel(each.mesh)));
    json.beginArray(Layout::row);
    json.number(std::int64_t{each.tailTeeth});
    json.number(std::int64_t{each.headTeeth});
    json.endArray();
  }
  json.endObject();
}

void writeNumber(JsonWriter& json, std::string_view name, const std::optional<double>& value) {
  json.key(name);
  value ? json.numberOrNull(*value) : json.null();
}

void writeChoice(JsonWriter& json, const TeethProblem& problem, const TeethChoice& choice) {
  json.beginObject(Layout::row);
  json.key("teeth");
  writeTeethOf(json, problem.train, choice.teeth);
  json.key("ratios");
  json.beginArray(Layout::row);
  for (const Rational& ratio : choice.found.ratios) json.string(ratio.toString());
  json.endArray();
  json.key("errors");
  json.beginArray(Layout::row);
  for (const Rational& error : choice.found.errors) json.number(error.toDouble());
  json.endArray();
  json.member("error", choice.found.error.toDouble());
  json.key("planets");
  json.beginArray(Layout::row);
  for (const int planets : choice.planets) json.number(std::int64_t{planets});
  json.endArray();
  json.key("hunting");
  json.beginObject(Layout::row);
  for (std::size_t mesh = 0; mesh < choice.hunting.size(); ++mesh)
    json.member(std::to_string(problem.train.meshLabel(static_cast<int>(mesh))), choice.hunting[mesh] != 0);
  json.endObject();
  json.key("undercut");
  json.beginArray(Layout::row);
  for (const std::string& gear : choice.undercut) json.string(gear);
  json.endArray();
  writeNumber(json, "efficiency", choice.efficiency);
  writeNumber(json, "efficiencyBackward", choice.backward);
  json.endObject();
}

}  // namespace

std::vector<std::pair<std::string, std::int64_t>> filtersOf(const TeethProblem& problem,
                                                            const TeethCounts& counts) {
  std::vector<std::pair<std::string, std::int64_t>> filters{{"turns", counts.turns}};
  if (problem.hasPlanets()) {
    filters.emplace_back("clears", counts.clears);
    filters.emplace_back("assembles", counts.assembles);
  }
  if (problem.wish.onlyHunting) filters.emplace_back("hunting", counts.hunts);
  if (!problem.wish.allowsUndercut) filters.emplace_back("undercut", counts.stands);
  if (problem.wish.leastEfficiency.sign() > 0) filters.emplace_back("within", counts.within);
  return filters;
}

std::string teethJson(const TeethAnswer& answer) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-teeth");
    json.member("version", 1);
    json.member("complete", answer.found.isComplete);
    json.member("tried", answer.found.counts.tried);
    json.key("filters");
    json.beginArray(Layout::row);
    for (const auto& [name, count] : filtersOf(*answer.problem, answer.found.counts)) {
      json.beginArray(Layout::row);
      json.string(name);
      json.number(count);
      json.endArray();
    }
    json.endArray();
    json.member("count", answer.found.counts.accepted);
    json.key("choices");
    json.beginArray();
    for (const TeethChoice& choice : answer.choices) writeChoice(json, *answer.problem, choice);
    json.endArray();
    json.key("nearest");
    answer.nearest ? writeChoice(json, *answer.problem, *answer.nearest) : json.null();
    json.key("conflicts");
    json.beginArray(Layout::row);
    for (const std::vector<int>& conflict : answer.conflicts) {
      json.beginArray(Layout::row);
      for (const int wish : conflict) json.number(std::int64_t{wish});
      json.endArray();
    }
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

}  // namespace geargraph
