#include "core/design/gearboxes/gearbox_wish.h"

#include <algorithm>
#include <cmath>

#include "core/design/gearboxes/wish_members.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr std::string_view kKinds =
    toTranslate("a list of 1 to 4 sets, \"simple\", \"double\" or \"ravigneaux\", which counts twice");

std::optional<SetKind> kindNamed(JsonValue value) {
  if (!value.is(JsonKind::string)) return std::nullopt;
  if (value.equals("simple")) return SetKind::simple;
  if (value.equals("double")) return SetKind::doublePlanet;
  if (value.equals("ravigneaux")) return SetKind::ravigneaux;
  return std::nullopt;
}

void readKinds(JsonObject& object, GearboxWish& wish) {
  const auto value = object.required("sets", kKinds);
  if (!value) return;
  bool isRight = value->is(JsonKind::array) && value->size() > 0;
  if (value->is(JsonKind::array)) {
    value->forEachElement([&](JsonValue each, std::size_t) {
      const auto kind = kindNamed(each);
      if (kind) wish.limits.kinds.push_back(*kind);
      isRight = isRight && kind;
    });
  }
  if (!isRight || basicSets(wish.limits.kinds).size() > kMaxSets) {
    object.wrong("sets", *value, kKinds);
    wish.limits.kinds.clear();
  }
}

void readLayouts(JsonObject& object, GearboxWish& wish) {
  readKinds(object, wish);
  const auto sets = static_cast<int>(basicSets(wish.limits.kinds).size());
  const int fewest = sets + 2;
  const int most = std::min(sets + kMaxFreedom, kMaxShafts);
  const std::string links =
      translated("a whole number from %1 to %2", {std::to_string(fewest), std::to_string(most)});
  if (object.required("links", links)) {
    wish.limits.shafts = sets == 0 ? wish.limits.shafts : wholeMember(object, "links", fewest, most, fewest);
  }
  wish.limits.held = wholeMember(object, "held", 0, 3, 0);
  wish.limits.freeInput = object.flag("freeInput").value_or(true);
}

void readReverse(JsonObject& object, GearboxWish& wish, const std::optional<Rational>& tolerance) {
  const auto value = object.member("reverse");
  if (!value) return;
  if (value->is(JsonKind::null)) {
    wish.reverse = ReverseWish::none;
  } else if (!value->is(JsonKind::string) || !value->equals("any")) {
    wish.reverse = ReverseWish::ratio;
    wish.reverseRatio = sizeOf(object, "reverse", *value, tolerance);
  }
}

void readElements(JsonObject& object, GearboxWish& wish) {
  wish.elements = wholeMember(object, "elements", 1, kMaxElements, wish.elements);
  wish.brakes = rangeMember(object, "brakes", 0, 9, wish.brakes);
  wish.clutches = rangeMember(object, "clutches", 0, 9, wish.clutches);
  wish.isSingleShift = object.flag("singleShift").value_or(true);
}

void readK(JsonObject& object, GearboxWish& wish) {
  constexpr std::string_view kRange =
      toTranslate("a list of two numbers above 1 and at most 10, the smaller one first");
  const auto value = object.member("k");
  if (value) {
    bool isRight = value->is(JsonKind::array) && value->size() == 2;
    std::array<std::optional<Rational>, 2> ends;
    for (std::size_t i = 0; i < 2 && isRight; ++i) {
      const JsonValue each = *value->element(i);
      const std::string text = each.is(JsonKind::string) ? each.string() : std::string(each.slice());
      ends[i] = Rational::fromText(text);
      isRight = ends[i] && *ends[i] > Rational(1) && *ends[i] <= Rational(10);
    }
    if (isRight && *ends[0] < *ends[1]) {
      wish.leastK = *ends[0];
      wish.mostK = *ends[1];
    } else {
      object.wrong("k", *value, kRange);
    }
  }
  wish.steps = wholeMember(object, "grid", 2, 24, wish.steps);
}

void readTeeth(JsonObject& object, JsonDiagnostics& diagnostics, GearboxWish& wish) {
  const auto value = object.member("teeth");
  if (!value) return;
  JsonObject teeth(diagnostics, *value, object.pointer() + pointerStep("teeth"));
  wish.teeth.mostRing = wholeMember(teeth, "mostRing", 20, 400, wish.teeth.mostRing);
  wish.teeth.fewest = wholeMember(teeth, "fewest", 6, wish.teeth.mostRing, wish.teeth.fewest);
  wish.teeth.slack = wholeMember(teeth, "slack", 0, 2, wish.teeth.slack);
  rejectUnknown(teeth, *value);
}

void readEfficiency(JsonObject& object, JsonDiagnostics& diagnostics, GearboxWish& wish) {
  constexpr std::string_view kEfficiency = toTranslate("an efficiency above 0, at most 1");
  const auto value = object.member("efficiency");
  if (!value) return;
  JsonObject members(diagnostics, *value, object.pointer() + pointerStep("efficiency"));
  EfficiencyWish efficiency;
  const auto read = [&](std::string_view name) {
    auto number = positiveMember(members, name);
    if (number && *number > Rational(1)) members.wrong(name, *value->member(name), kEfficiency);
    return number;
  };
  const auto ofMesh = read("mesh");
  const auto ofSet = read("set");
  efficiency.least = read("least");
  if (value->is(JsonKind::object) && ofMesh.has_value() == ofSet.has_value() &&
      !diagnostics.covers(members.pointer())) {
    diagnostics.add(Code::schema, translated("one of \"mesh\" and \"set\" is needed, not both."), {},
                    members.pointer(), *value);
  }
  rejectUnknown(members, *value);
  efficiency.isOfSet = ofSet.has_value();
  efficiency.basic = ofSet ? *ofSet : ofMesh.value_or(Rational(1));
  wish.efficiency = efficiency;
}

}  // namespace

Expected<GearboxWish> readGearboxWish(std::string_view json) {
  const auto document = JsonDocument::parse(json);
  if (!document) return document.error();
  JsonDiagnostics diagnostics(*document);
  checkJson(*document, diagnostics);
  if (!diagnostics.empty()) return diagnostics.inOrder();
  const JsonValue root = document->root();
  JsonObject object(diagnostics, root, "");
  GearboxWish wish;
  wish.canonical = root.compact();
  const auto tolerance = toleranceMember(object);
  wish.forward = ratiosMember(object, "forward", kMaxGears, tolerance);
  readReverse(object, wish, tolerance);
  readLayouts(object, wish);
  readElements(object, wish);
  readK(object, wish);
  readTeeth(object, diagnostics, wish);
  readEfficiency(object, diagnostics, wish);
  wish.torque = positiveMember(object, "torque");
  wish.speed = positiveMember(object, "speed");
  wish.slip = positiveMember(object, "slip");
  wish.circulating = positiveMember(object, "circulating");
  wish.spread = positiveMember(object, "spread");
  wish.isBuildable = object.flag("buildable").value_or(false);
  rejectUnknown(object, root);
  if (!diagnostics.empty()) return diagnostics.inOrder();
  return wish;
}

SearchProblem searchProblem(const GearboxWish& wish) {
  const auto targetOf = [](const WantedRatio& ratio) {
    const double value = ratio.value.toDouble();
    return RatioTarget{
        ratio.value == Rational(1) ? 0 : std::log(value),
        std::max(std::log(ratio.highest.toDouble() / value), std::log(value / ratio.lowest.toDouble()))};
  };
  SearchProblem problem;
  problem.limits = wish.limits;
  for (const WantedRatio& ratio : wish.forward) problem.forward.push_back(targetOf(ratio));
  problem.reverse = wish.reverse;
  if (wish.reverseRatio) problem.reverseTarget = targetOf(*wish.reverseRatio);
  problem.mostElements = wish.elements;
  problem.isSingleShift = wish.isSingleShift;
  problem.leastK = wish.leastK.toDouble();
  problem.mostK = wish.mostK.toDouble();
  problem.steps = wish.steps;
  return problem;
}

}  // namespace geargraph
