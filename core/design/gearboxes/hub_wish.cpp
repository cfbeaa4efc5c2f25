#include "core/design/gearboxes/hub_wish.h"

#include <algorithm>

#include "core/design/gearboxes/wish_members.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr int kMaxTeethOfHub = 400;

/// "1.ring", "2.sun1", "1.planet3": a wheel of one of the sets.
bool isWheelName(std::string_view name, const HubWish& wish) {
  if (name.size() < 3 || name[1] != '.' || name[0] < '1' || name[0] > '0' + wish.sets) return false;
  const std::string_view wheel = name.substr(2);
  if (wheel == "ring") return true;
  for (const std::string_view kind : {"sun", "planet"}) {
    if (wheel.starts_with(kind) && wheel.size() == kind.size() + 1 && wheel.back() >= '1' &&
        wheel.back() <= '0' + kMaxHubSuns)
      return true;
  }
  return false;
}

void readCounted(JsonObject& object, JsonDiagnostics& diagnostics, HubWish& wish) {
  const auto value = object.member("counted");
  if (!value) return;
  if (!value->is(JsonKind::object)) {
    object.wrong("counted", *value, toTranslate("an object of wheels with their teeth, {\"1.ring\": 72}"));
    return;
  }
  JsonObject wheels(diagnostics, *value, object.pointer() + pointerStep("counted"));
  value->forEachMember([&](JsonValue key, JsonValue) {
    const std::string name = key.string();
    if (isWheelName(name, wish)) {
      wish.counted[name] = wholeMember(wheels, name, 1, kMaxTeethOfHub, 1);
    } else {
      diagnostics.add(Code::schema,
                      translated("there is no wheel \"%1\"; wheels are named like \"1.ring\", \"2.sun1\", "
                                 "\"2.planet1\".",
                                 {name}),
                      {}, wheels.pointer() + pointerStep(name), key);
    }
  });
}

void readMeasured(JsonObject& object, JsonDiagnostics& diagnostics, HubWish& wish) {
  const auto list = object.member("measured");
  if (!list) return;
  if (!list->is(JsonKind::array)) {
    object.wrong("measured", *list,
                 toTranslate("a list of gears with ratios, {\"gear\": 4, \"ratio\": \"0.98884\"}"));
    return;
  }
  list->forEachElement([&](JsonValue each, std::size_t position) {
    JsonObject members(diagnostics, each, object.pointer() + pointerStep("measured") + pointerStep(position));
    MeasuredRatio measured;
    measured.gear =
        members.requiredWhole("gear", 1, static_cast<int>(std::max<std::size_t>(wish.ratios.size(), 1))) - 1;
    const auto ratio = members.required("ratio", toTranslate("a ratio in a string"));
    auto read = ratio ? sizeOf(members, "ratio", *ratio, {}) : std::nullopt;
    rejectUnknown(members, each);
    if (!read) return;
    measured.ratio = *std::move(read);
    wish.measured.push_back(std::move(measured));
  });
}

/// Sheets give developments in metres, or percent: what counts are the ratios to the gear that is direct.
void relateToDirect(HubWish& wish) {
  if (wish.direct < 0) return;
  const auto position = static_cast<std::size_t>(wish.direct);
  const WantedRatio direct = wish.ratios[position];
  for (std::size_t gear = 0; gear < wish.ratios.size(); ++gear) {
    WantedRatio& own = wish.ratios[gear];
    own.value /= direct.value;
    own.lowest = gear == position ? Rational(1) : own.lowest / direct.highest;
    own.highest = gear == position ? Rational(1) : own.highest / direct.lowest;
    own.isHighestIn = own.isHighestIn || gear == position;
  }
}

/// Only what is searched may be wished for: `series` and `oneSunHeld` are true.
void requireTrue(JsonObject& object, std::string_view name, const char* why) {
  const auto value = object.member(name);
  if (!value || object.flag(name).value_or(true)) return;
  object.diagnostics().add(Code::schema, translated(std::string_view(why)), {},
                           object.pointer() + pointerStep(name), *value);
}

}  // namespace

Expected<HubWish> readHubWish(std::string_view json) {
  const auto document = JsonDocument::parse(json);
  if (!document) return document.error();
  JsonDiagnostics diagnostics(*document);
  checkJson(*document, diagnostics);
  if (!diagnostics.empty()) return diagnostics.inOrder();
  const JsonValue root = document->root();
  JsonObject object(diagnostics, root, "");
  HubWish wish;
  wish.ratios = ratiosMember(object, "ratios", kMaxHubRatios, toleranceMember(object));
  wish.direct = wholeMember(object, "direct", 0, static_cast<int>(wish.ratios.size()), 0) - 1;
  relateToDirect(wish);
  wish.sets = wholeMember(object, "sets", 1, kMaxHubSets, wish.sets);
  requireTrue(object, "series", toTranslate("only sets in series are searched."));
  requireTrue(object, "oneSunHeld",
              toTranslate("only sets of which one sun is held at a time are searched."));
  wish.isStepped = object.flag("stepped").value_or(true);
  wish.planets = rangeMember(object, "planets", 4, kMaxTeethOfHub, wish.planets);
  wish.suns = rangeMember(object, "suns", 4, kMaxTeethOfHub, wish.suns);
  wish.rings = rangeMember(object, "rings", 8, kMaxTeethOfHub, wish.rings);
  wish.slack = wholeMember(object, "slack", 0, 4, wish.slack);
  readCounted(object, diagnostics, wish);
  readMeasured(object, diagnostics, wish);
  rejectUnknown(object, root);
  if (!diagnostics.empty()) return diagnostics.inOrder();
  return wish;
}

}  // namespace geargraph
