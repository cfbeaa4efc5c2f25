#include "core/design/gearboxes/gearbox_json.h"

#include <algorithm>

#include "core/design/gearboxes/gearbox_document.h"
#include "core/foundations/files/json_writer.h"

namespace geargraph {
namespace {

using Layout = JsonWriter::Layout;

void writeNames(JsonWriter& json, const std::vector<std::string>& names) {
  json.beginArray(Layout::row);
  for (const std::string& each : names) json.string(each);
  json.endArray();
}

void writeElement(JsonWriter& json, const BasicSets& sets, const GearLayout& layout,
                  const ElementLinks& element) {
  json.member("kind", element.isBrake() ? "brake" : "clutch");
  json.key("links");
  std::vector<std::string> links{linkWord(sets, layout, element.a)};
  if (!element.isBrake()) links.push_back(linkWord(sets, layout, element.b));
  writeNames(json, links);
}

void writeElements(JsonWriter& json, const BasicSets& sets, const Gearbox& gearbox) {
  json.key("elements");
  json.beginArray();
  for (std::size_t i = 0; i < gearbox.elements.size(); ++i) {
    json.beginObject(Layout::row);
    json.member("id", std::string(1, static_cast<char>('A' + i)));
    writeElement(json, sets, gearbox.layout, gearbox.elements[i]);
    json.key("variants");
    json.beginArray(Layout::row);
    for (const ElementLinks& each : gearbox.variants[i]) {
      if (each == gearbox.elements[i]) continue;
      json.beginObject(Layout::row);
      writeElement(json, sets, gearbox.layout, each);
      json.endObject();
    }
    json.endArray();
    json.endObject();
  }
  json.endArray();
}

void numberOrNone(JsonWriter& json, const std::optional<Rational>& value) {
  if (value) {
    json.number(value->toDouble());
  } else {
    json.null();
  }
}

void writeMeasures(JsonWriter& json, const GearMeasures& measures) {
  json.member("power", measures.power.toDouble());
  json.member("torque", measures.torque.toDouble());
  json.member("slip", measures.slip.toDouble());
  json.member("speed", measures.speed.toDouble());
}

void writeStates(JsonWriter& json, const Gearbox& gearbox) {
  json.key("states");
  json.beginArray();
  for (std::size_t i = 0; i < gearbox.gears.size(); ++i) {
    const GearState& gear = gearbox.gears[i];
    json.beginObject(Layout::row);
    json.member("name", gear.name);
    json.key("engaged");
    std::vector<std::string> engaged;
    for (const int each : gear.engaged) engaged.emplace_back(1, static_cast<char>('A' + each));
    writeNames(json, engaged);
    json.member("ratio", gear.ratio.toString());
    json.member("error", gear.error.toDouble());
    writeMeasures(json, gear.measures);
    if (gearbox.losses) {
      json.key("efficiency");
      numberOrNone(json, gearbox.losses->efficiencies[i]);
      json.key("circulating");
      numberOrNone(json, gearbox.losses->circulating[i]);
    }
    json.endObject();
  }
  json.endArray();
}

void writeTeeth(JsonWriter& json, const Gearbox& gearbox, const std::vector<SetKind>& kinds) {
  json.key("teeth");
  json.beginArray();
  for (std::size_t i = 0; i < gearbox.teeth.size(); ++i) {
    for (std::size_t part = 0; part < gearbox.teeth[i].parts.size(); ++part) {
      const SetTeeth& teeth = gearbox.teeth[i].parts[part];
      json.beginObject(Layout::row);
      json.member("sun", teeth.sun);
      json.member("planet", teeth.planet);
      if (teeth.outer != 0) json.member("outer", teeth.outer);
      json.member("ring", teeth.ring);
      if (kinds[i] == SetKind::doublePlanet || part == 1) json.member("double", true);
      if (part == 0) {
        json.key("planets");
        json.beginArray(Layout::row);
        for (const int each : gearbox.teeth[i].planets) json.number(static_cast<std::int64_t>(each));
        json.endArray();
      }
      json.endObject();
    }
  }
  json.endArray();
}

void writeGearbox(JsonWriter& json, const GearboxWish& wish, const Gearbox& gearbox) {
  const BasicSets sets = basicSets(wish.limits.kinds);
  json.beginObject();
  json.key("links");
  json.beginArray();
  for (int link = 1; link <= wish.limits.shafts; ++link)
    writeNames(json, membersOn(sets, gearbox.layout, link));
  json.endArray();
  json.key("held");
  writeNames(json, membersOn(sets, gearbox.layout, 0));
  writeElements(json, sets, gearbox);
  writeStates(json, gearbox);
  writeTeeth(json, gearbox, wish.limits.kinds);
  json.member("error", gearbox.error.toDouble());
  writeMeasures(json, gearbox.measures);
  json.member("spread",
              (gearbox.gears.front().ratio / gearbox.gears[wish.forward.size() - 1].ratio).toDouble());
  json.member("buildable", !gearbox.brokenRule.has_value());
  json.key("brokenRule");
  if (gearbox.brokenRule) {
    json.string(sectionRuleName(*gearbox.brokenRule));
  } else {
    json.null();
  }
  json.endObject();
}

void writeSampling(JsonWriter& json, const GearboxWish& wish) {
  const SearchProblem problem = searchProblem(wish);
  const auto sets = static_cast<int>(basicSets(wish.limits.kinds).size());
  const bool isGrid = wish.limits.shafts - sets < kMaxFreedom;
  json.key("sampling");
  json.beginObject(Layout::row);
  json.member("of", isGrid ? "grid" : "halton");
  json.member("steps", isGrid ? problem.steps : kSamples);
  json.key("k");
  json.beginArray(Layout::row);
  json.string(wish.leastK.toString());
  json.string(wish.mostK.toString());
  json.endArray();
  json.endObject();
}

void writeCounts(JsonWriter& json, const GearboxSearch& search) {
  json.key("counts");
  json.beginArray(Layout::row);
  const auto count = [&json](std::string_view name, std::int64_t value) {
    json.beginArray(Layout::row);
    json.string(name);
    json.number(value);
    json.endArray();
  };
  count("states", search.counts.states);
  count("points", search.counts.points);
  count("tables", search.counts.candidates);
  count("near", search.judged.candidates);
  count("teeth", search.judged.teeth);
  count("elements", search.judged.elements);
  count("limits", search.judged.limits);
  json.endArray();
}

std::optional<int> wholeIn(JsonValue value, int lowest, int highest) {
  if (!value.is(JsonKind::number)) return std::nullopt;
  const auto exact = Rational::fromText(value.slice());
  if (!exact || !exact->isInteger() || *exact < Rational(lowest) || *exact > Rational(highest))
    return std::nullopt;
  return static_cast<int>(exact->toDouble());
}

/// The whole numbers of a list; empty if it is none.
std::vector<int> wholesOf(std::optional<JsonValue> list, int lowest, int highest) {
  std::vector<int> result;
  if (!list || !list->is(JsonKind::array)) return result;
  bool isRight = true;
  list->forEachElement([&](JsonValue each, std::size_t) {
    const auto whole = wholeIn(each, lowest, highest);
    isRight = isRight && whole;
    result.push_back(whole.value_or(0));
  });
  return isRight ? result : std::vector<int>();
}

std::vector<std::vector<int>> listsOf(std::optional<JsonValue> list, int lowest, int highest) {
  std::vector<std::vector<int>> result;
  if (!list || !list->is(JsonKind::array)) return result;
  list->forEachElement(
      [&](JsonValue each, std::size_t) { result.push_back(wholesOf(each, lowest, highest)); });
  return result;
}

void appendNumbers(std::string& text, std::span<const int> numbers) {
  text += '[';
  for (std::size_t i = 0; i < numbers.size(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  text += ']';
}

}  // namespace

std::vector<std::string> membersOn(const BasicSets& sets, const GearLayout& layout, int link) {
  std::vector<std::string> names;
  if (link != 0 && link == layout.input) names.emplace_back("in");
  if (link != 0 && link == layout.output) names.emplace_back("out");
  for (int set = 0; set < static_cast<int>(sets.size()); ++set) {
    for (const SetMember member : {SetMember::sun, SetMember::carrier, SetMember::ring}) {
      if (layout.link(set, member) == link) names.push_back(memberName(set, member));
    }
  }
  return names;
}

std::string linkWord(const BasicSets& sets, const GearLayout& layout, int link) {
  const std::vector<std::string> names = membersOn(sets, layout, link);
  const auto member = std::find_if(names.begin(), names.end(),
                                   [](const std::string& each) { return each != "in" && each != "out"; });
  if (member != names.end()) return *member;
  return names.empty() ? std::string() : names.front();  // a free input
}

std::optional<std::string> gearboxesJson(const GearboxWish& wish, GearboxSearch search, std::int64_t limit,
                                         const std::stop_token& stop) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-gearboxes");
    json.member("version", 1);
    json.key("wish");
    json.json(wish.canonical);
    json.member("layouts", search.layouts);
    json.member("searched", search.searched);
    json.member("complete", search.isComplete);
    writeSampling(json, wish);
    writeCounts(json, search);
    json.member("count", static_cast<std::int64_t>(search.found.size()));
    json.key("gearboxes");
    json.beginArray();
    std::int64_t shown = 0;
    for (Gearbox& each : search.found) {
      if (limit >= 0 && shown++ >= limit) break;
      if (checkByDocument(wish, each, true, stop) == GearboxCheck::stopped) return std::nullopt;
      writeGearbox(json, wish, each);
    }
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

std::string gearboxRecord(const Gearbox& gearbox) {
  std::string text = "{\"layout\": ";
  std::vector<int> numbers(gearbox.layout.linkOf.begin(), gearbox.layout.linkOf.end());
  numbers.push_back(gearbox.layout.input);
  numbers.push_back(gearbox.layout.output);
  appendNumbers(text, numbers);
  text += ", \"elements\": [";
  for (std::size_t i = 0; i < gearbox.elements.size(); ++i) {
    text += i == 0 ? "" : ", ";
    appendNumbers(text, std::array<int, 2>{gearbox.elements[i].a, gearbox.elements[i].b});
  }
  text += "], \"gears\": [";
  for (std::size_t i = 0; i < gearbox.gears.size(); ++i) {
    text += i == 0 ? "" : ", ";
    appendNumbers(text, gearbox.gears[i].engaged);
  }
  text += "], \"teeth\": [";
  bool isFirst = true;
  for (const TeethOption& option : gearbox.teeth) {
    for (const SetTeeth& part : option.parts) {
      text += isFirst ? "" : ", ";
      isFirst = false;
      appendNumbers(text, std::array<int, 4>{part.sun, part.planet, part.outer, part.ring});
    }
  }
  return text + "]}";
}

std::optional<Gearbox> gearboxFromRecord(const GearboxWish& wish, JsonValue record) {
  if (!record.is(JsonKind::object)) return std::nullopt;
  const BasicSets sets = basicSets(wish.limits.kinds);
  const std::vector<int> layout = wholesOf(record.member("layout"), 0, wish.limits.shafts);
  const auto elements = listsOf(record.member("elements"), 0, wish.limits.shafts);
  const auto teeth = listsOf(record.member("teeth"), 0, 100'000);
  Gearbox gearbox;
  if (layout.size() != gearbox.layout.linkOf.size() + 2 || elements.empty() || teeth.size() != sets.size())
    return std::nullopt;
  for (std::size_t i = 0; i < gearbox.layout.linkOf.size(); ++i)
    gearbox.layout.linkOf[i] = static_cast<std::uint8_t>(layout[i]);
  gearbox.layout.input = static_cast<std::uint8_t>(layout[layout.size() - 2]);
  gearbox.layout.output = static_cast<std::uint8_t>(layout.back());
  for (const auto& each : elements) {
    if (each.size() != 2) return std::nullopt;
    gearbox.elements.push_back({static_cast<std::uint8_t>(each[0]), static_cast<std::uint8_t>(each[1])});
  }
  std::size_t set = 0;
  for (const SetKind kind : wish.limits.kinds) {
    TeethOption option;
    for (std::size_t part = 0; part < (kind == SetKind::ravigneaux ? 2U : 1U); ++part, ++set) {
      if (teeth[set].size() != 4 || teeth[set][0] < 1 || teeth[set][3] < 1) return std::nullopt;
      option.parts.push_back({teeth[set][0], teeth[set][1], teeth[set][2], teeth[set][3]});
    }
    gearbox.teeth.push_back(std::move(option));
  }
  for (const auto& each : listsOf(record.member("gears"), 0, static_cast<int>(elements.size()) - 1)) {
    GearState state;
    state.engaged = each;
    gearbox.gears.push_back(std::move(state));
  }
  return evaluated(wish, std::move(gearbox));
}

}  // namespace geargraph
