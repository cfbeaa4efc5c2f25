#include "core/design/gearboxes/hub_json.h"

#include <algorithm>

#include "core/foundations/files/json_writer.h"

namespace geargraph {
namespace {

using Row = JsonWriter::Layout;

void writeHubSet(JsonWriter& json, const HubSet& set) {
  json.beginObject(Row::row);
  json.key("suns");
  json.beginArray(Row::row);
  for (const HubSun& sun : set.suns) {
    json.beginObject(Row::row);
    json.member("teeth", sun.teeth);
    json.member("planet", sun.planet);
    const auto gear = [&json](std::string_view name, int position) {
      json.key(name);
      if (position < 0) {
        json.null();
      } else {
        json.number(static_cast<std::int64_t>(position + 1));
      }
    };
    gear("reduction", sun.reduction);
    gear("increase", sun.increase);
    json.endObject();
  }
  json.endArray();
  json.member("ring", set.ring);
  json.key("planets");
  json.beginArray(Row::row);
  for (const int each : set.planets) json.number(static_cast<std::int64_t>(each));
  json.endArray();
  json.endObject();
}

void writeCandidates(JsonWriter& json, std::string_view name, const std::vector<HubCandidate>& candidates,
                     const HubWish& wish, std::int64_t limit) {
  json.key(name);
  json.beginArray();
  std::int64_t shown = 0;
  for (const HubCandidate& each : candidates) {
    if (limit >= 0 && shown++ >= limit) break;
    json.beginObject();
    json.key("sets");
    json.beginArray();
    for (const HubSet& set : each.sets) writeHubSet(json, set);
    json.endArray();
    json.key("ratios");
    json.beginArray(Row::row);
    for (const Rational& ratio : each.ratios) json.string(ratio.toString());
    json.endArray();
    json.key("errors");
    json.beginArray(Row::row);
    for (std::size_t gear = 0; gear < each.ratios.size(); ++gear)
      json.number(wish.ratios[gear].errorOf(each.ratios[gear]).toDouble());
    json.endArray();
    json.endObject();
  }
  json.endArray();
}

void writeQuestion(JsonWriter& json, const HubQuestion& question) {
  json.beginObject(Row::row);
  json.member("of", question.name);
  json.member("kind", question.isCount ? "count" : "turns");
  json.member("leaves", static_cast<std::int64_t>(question.leaves));
  json.key("answers");
  json.beginArray(Row::row);
  for (const auto& [answer, candidates] : leftBy(question)) {
    json.beginObject(Row::row);
    json.key("answer");
    if (answer.empty()) {
      json.null();  // there is no such wheel
    } else {
      json.json(answer);
    }
    json.key("candidates");
    json.beginArray(Row::row);
    for (const std::size_t each : candidates) json.number(static_cast<std::int64_t>(each + 1));
    json.endArray();
    json.endObject();
  }
  json.endArray();
  json.endObject();
}

}  // namespace

std::vector<std::pair<std::string, int>> sharedWheels(const HubSearch& search) {
  std::vector<std::pair<std::string, int>> shared;
  if (search.assembled.empty()) return shared;
  for (const auto& wheel : hubWheels(search.assembled.front())) {
    const bool isShared =
        std::all_of(search.assembled.begin(), search.assembled.end(), [&](const HubCandidate& each) {
          const auto wheels = hubWheels(each);
          return std::find(wheels.begin(), wheels.end(), wheel) != wheels.end();
        });
    if (isShared) shared.push_back(wheel);
  }
  return shared;
}

std::vector<std::vector<std::size_t>> inseparable(const HubSearch& search) {
  std::map<std::vector<Rational>, std::vector<std::size_t>> byRatios;
  for (std::size_t i = 0; i < search.assembled.size(); ++i) byRatios[search.assembled[i].ratios].push_back(i);
  std::vector<std::vector<std::size_t>> groups;
  for (auto& [ratios, candidates] : byRatios) {
    if (candidates.size() > 1) groups.push_back(std::move(candidates));
  }
  std::sort(groups.begin(), groups.end());
  return groups;
}

std::map<std::string, std::vector<std::size_t>> leftBy(const HubQuestion& question) {
  std::map<std::string, std::vector<std::size_t>> left;
  for (std::size_t i = 0; i < question.answers.size(); ++i) left[question.answers[i]].push_back(i);
  return left;
}

std::string hardwareJson(const HubWish& wish, const HubSearch& search, std::int64_t limit) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-hardware");
    json.member("version", 1);
    json.member("complete", true);
    json.member("structures", search.structures);
    json.key("tried");
    json.beginArray(Row::row);
    for (const std::int64_t each : search.tried) json.number(each);
    json.endArray();
    json.member("fitting", static_cast<std::int64_t>(search.assembled.size() + search.others.size()));
    json.member("count", static_cast<std::int64_t>(search.assembled.size()));
    writeCandidates(json, "candidates", search.assembled, wish, limit);
    writeCandidates(json, "unassembled", search.others, wish, limit);
    json.key("shared");
    json.beginObject(Row::row);
    for (const auto& [name, teeth] : sharedWheels(search)) json.member(name, teeth);
    json.endObject();
    json.key("inseparable");
    json.beginArray(Row::row);
    for (const auto& group : inseparable(search)) {
      json.beginArray(Row::row);
      for (const std::size_t each : group) json.number(static_cast<std::int64_t>(each + 1));
      json.endArray();
    }
    json.endArray();
    json.key("decide");
    if (search.questions.empty()) {
      json.null();
    } else {
      writeQuestion(json, search.questions.front());
    }
    json.key("questions");
    json.beginArray();
    for (const HubQuestion& each : search.questions) writeQuestion(json, each);
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

}  // namespace geargraph
