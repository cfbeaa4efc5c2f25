#include "core/design/teeth_wish/teeth_wish.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/mechanism/document_format/json_object.h"

namespace geargraph {
namespace {

constexpr std::string_view kRatio =
    toTranslate("a ratio other than 0: a number, or a string like \"9/2\" or \"0.632\"");

class WishReader {
 public:
  WishReader(const JsonDocument& document, const Mechanism& mechanism)
      : m_found(document), m_mechanism(mechanism), m_root(document.root()) {}

  Expected<TeethWish> run() {
    JsonObject from(m_found, m_root, "");
    readRatios(from);
    m_wish.fewest = whole(from, "fewest", m_wish.fewest, kMinTeeth, kMaxSearchedTeeth);
    m_wish.most = whole(from, "most", m_wish.most, kMinTeeth, kMaxSearchedTeeth);
    m_wish.mostRing =
        whole(from, "mostRing", std::max(m_wish.mostRing, m_wish.most), kMinTeeth, kMaxSearchedTeeth);
    m_wish.planets = whole(from, "planets", 0, 1, kMaxWishedPlanets);
    m_wish.slack = whole(from, "slack", 0, 0, kMaxSlack);
    m_wish.hasOneModule = choice(from, "module", "one", "free");
    m_wish.keepsDistances = !choice(from, "distances", "free", "kept");
    m_wish.onlyHunting = from.flag("hunting").value_or(false);
    m_wish.allowsUndercut = from.flag("undercut").value_or(true);
    readStock(from);
    readKept(from);
    readEfficiency(from);
    rejectUnknown(from);
    if (m_wish.fewest > m_wish.most)
      fail("/fewest", "fewest",
           translated("There are no teeth from %1 to %2.",
                      {std::to_string(m_wish.fewest), std::to_string(m_wish.most)}));
    if (!m_found.empty()) return m_found.inOrder();
    return std::move(m_wish);
  }

 private:
  void fail(const std::string& pointer, std::string_view member, std::string message,
            Code code = Code::schema) {
    const auto at = m_root.is(JsonKind::object) ? m_root.member(member) : std::nullopt;
    if (!m_found.covers(pointer)) m_found.add(code, std::move(message), {}, pointer, at.value_or(m_root));
  }

  static int whole(JsonObject& from, std::string_view name, int otherwise, int lowest, int highest) {
    return from.member(name) ? from.requiredWhole(name, lowest, highest) : otherwise;
  }

  /// True for the first of two words, also without the member.
  static bool choice(JsonObject& from, std::string_view name, std::string_view first,
                     std::string_view second) {
    const auto value = from.member(name);
    if (!value || (value->is(JsonKind::string) && value->equals(first))) return true;
    if (value->is(JsonKind::string) && value->equals(second)) return false;
    from.wrong(name, *value, translated("\"%1\" or \"%2\"", {first, second}));
    return true;
  }

  void rejectUnknown(JsonObject& from) {
    for (const auto& [name, text] : from.unknown())
      fail(from.pointer() + pointerStep(name), name,
           translated("There is no member \"%1\" in a wish.", {name}));
  }

  /// By its label, or by its id where no label is spelled so.
  [[nodiscard]] std::optional<LinkOrdinal> linkNamed(const std::string& name) const {
    for (LinkOrdinal link = 0; link <= m_mechanism.n(); ++link)
      if (std::to_string(m_mechanism.linkLabel(link)) == name) return link;
    for (LinkOrdinal link = 0; link <= m_mechanism.n(); ++link)
      if (m_mechanism.links[link].id.text() == name) return link;
    return std::nullopt;
  }

  LinkOrdinal linkAt(const InternedString& name, const std::string& pointer, JsonValue at) {
    if (name.empty()) return 0;  // said already
    const auto link = linkNamed(name.text());
    if (!link && !m_found.covers(pointer))
      m_found.add(Code::unknownId, translated("There is no link \"%1\".", {name.text()}), {}, pointer, at);
    return link.value_or(LinkOrdinal(0));
  }

  /// A number, or a text of one, as it is written.
  static std::optional<std::string> writtenNumber(JsonValue value) {
    if (value.is(JsonKind::number)) return std::string(value.slice());
    if (value.is(JsonKind::string)) return value.string();
    return std::nullopt;
  }

  std::optional<Rational> fraction(JsonObject& from, std::string_view name, JsonValue value,
                                   std::string_view expected) {
    const auto text = writtenNumber(value);
    const auto number = text ? Rational::fromText(*text) : std::nullopt;
    if (!number) from.wrong(name, value, expected);
    return number;
  }

  void readRatios(JsonObject& from) {
    const auto list = from.required("ratios", toTranslate("a list of ratios"));
    if (!list) return;
    if (!list->is(JsonKind::array) || list->size() == 0 || list->size() > std::size_t{kMaxWishedRatios})
      return from.wrong("ratios", *list,
                        translated("a list of 1 to %1 ratios", {std::to_string(kMaxWishedRatios)}));
    list->forEachElement([&](JsonValue value, std::size_t position) {
      JsonObject one(m_found, value, "/ratios" + pointerStep(position));
      m_wish.ratios.push_back(readRatio(one, value));
    });
  }

  RatioWish readRatio(JsonObject& from, JsonValue value) {
    RatioWish wish;
    readState(from, wish);
    readHeld(from, wish);
    const auto drive = endOf(from, "drive", value, wish);
    const auto driven = endOf(from, "driven", value, wish);
    wish.drive = drive.value_or(LinkOrdinal(0));
    wish.driven = driven.value_or(LinkOrdinal(0));
    if (drive && driven && wish.drive == wish.driven)
      m_found.add(Code::schema, translated("Drive and driven are one link."), {}, from.pointer() + "/driven",
                  value.member("driven").value_or(value));
    for (const LinkOrdinal end : {wish.drive, wish.driven}) {
      if (drive && driven && std::find(wish.held.begin(), wish.held.end(), end) != wish.held.end())
        m_found.add(Code::schema,
                    translated("Link %1 is held, so that it has no ratio.",
                               {std::to_string(m_mechanism.linkLabel(end))}),
                    {m_mechanism.links[end].id}, from.pointer() + "/held", value);
    }
    readBounds(from, wish);
    for (const auto& [name, text] : from.unknown())
      m_found.add(Code::schema, translated("There is no member \"%1\" in a wish.", {name}), {},
                  from.pointer() + pointerStep(name), value);
    return wish;
  }

  void readState(JsonObject& from, RatioWish& wish) {
    const auto value = from.member("state");
    if (!value) return;
    if (!value->is(JsonKind::string)) return from.wrong("state", *value, toTranslate("the name of a state"));
    for (std::size_t state = 0; state < m_mechanism.states.size(); ++state)
      if (m_mechanism.states[state].name == value->string()) wish.state = static_cast<int>(state);
    if (wish.state < 0)
      m_found.add(Code::unknownId, translated("There is no state \"%1\".", {value->string()}), {},
                  from.pointer() + "/state", *value);
  }

  void readHeld(JsonObject& from, RatioWish& wish) {
    const auto value = from.member("held");
    const auto names = from.ids("held");
    wish.isEngaged = !value && wish.state < 0;
    if (!names) return;
    if (from.member("state"))
      return m_found.add(Code::schema,
                         translated("A ratio is wanted in a state or with links held, not in both."), {},
                         from.pointer() + "/held", *value);
    std::vector<JsonValue> places;
    if (value->is(JsonKind::array))
      value->forEachElement([&](JsonValue each, std::size_t /*position*/) { places.push_back(each); });
    for (std::size_t i = 0; i < names->size(); ++i)
      wish.held.push_back(linkAt((*names)[i], from.pointer() + "/held" + pointerStep(i), places[i]));
    std::sort(wish.held.begin(), wish.held.end());
    wish.held.erase(std::unique(wish.held.begin(), wish.held.end()), wish.held.end());
  }

  /// The link named by the member, or by the state.
  std::optional<LinkOrdinal> endOf(JsonObject& from, std::string_view name, JsonValue value,
                                   const RatioWish& wish) {
    if (wish.state >= 0 && !from.member(name)) {
      const ShiftState& state = m_mechanism.states[static_cast<std::size_t>(wish.state)];
      const auto& end = name == "drive" ? state.drive : state.driven;
      if (end) return linkNamedById(*end);
    }
    const InternedString id = from.requiredId(name);
    if (id.empty()) return std::nullopt;
    return linkAt(id, from.pointer() + pointerStep(name), value.member(name).value_or(value));
  }

  [[nodiscard]] LinkOrdinal linkNamedById(LinkId id) const {
    LinkOrdinal link = 0;
    while (m_mechanism.links[link].id != id) ++link;
    return link;
  }

  void readBounds(JsonObject& from, RatioWish& wish) {
    const auto between = from.member("between");
    const auto ratio = from.member("ratio");
    const auto tolerance = from.member("tolerance");
    if (between) {
      if (ratio || tolerance)
        return from.wrong("between", *between, toTranslate("no ratio beside an interval"));
      return readInterval(from, *between, wish);
    }
    if (!from.required("ratio", kRatio)) return;
    const auto text = writtenNumber(*ratio);
    const auto bounds = text ? boundsOf(*text) : std::nullopt;
    const auto number = text ? Rational::fromText(*text) : std::nullopt;
    if (number && number->isZero())
      return m_found.add(Code::schema,
                         translated("With the ratio 0 the drive would stand still while link %1 turns.",
                                    {std::to_string(m_mechanism.linkLabel(wish.driven))}),
                         {}, from.pointer() + "/ratio", *ratio);
    if (!number || (!bounds && !tolerance)) return from.wrong("ratio", *ratio, kRatio);
    if (!tolerance) {
      wish.bounds = *bounds;
      return;
    }
    const auto share = fraction(from, "tolerance", *tolerance, kTolerance);
    if (!share) return;
    if (share->sign() < 0 || *share >= Rational(1)) return from.wrong("tolerance", *tolerance, kTolerance);
    wish.bounds = boundsWithin(*number, *share);
  }

  void readInterval(JsonObject& from, JsonValue value, RatioWish& wish) {
    std::vector<Rational> ends;
    if (value.is(JsonKind::array)) {
      value.forEachElement([&](JsonValue each, std::size_t /*position*/) {
        const auto text = writtenNumber(each);
        if (const auto end = text ? Rational::fromText(*text) : std::nullopt) ends.push_back(*end);
      });
    }
    const bool isInterval = value.is(JsonKind::array) && value.size() == 2 && ends.size() == 2 &&
                            ends[0] <= ends[1] && ends[0].sign() * ends[1].sign() > 0;
    if (!isInterval)
      return from.wrong("between", value, toTranslate("two ratios of one sign, the smaller first"));
    wish.bounds = boundsBetween(ends[0], ends[1]);
  }

  void readStock(JsonObject& from) {
    const auto value = from.member("wheels");
    const auto once = from.flag("once");
    m_wish.usesStockOnce = once.value_or(false);
    if (!value) {
      if (once)
        fail("/once", "once", translated("Without \"wheels\" there is none that could be used once."));
      return;
    }
    const std::string expected = translated("a list of 1 to %1 numbers of teeth from 1 to %2",
                                            {std::to_string(kMaxStock), std::to_string(kMaxSearchedTeeth)});
    if (!value->is(JsonKind::array) || value->size() == 0 || value->size() > std::size_t{kMaxStock})
      return from.wrong("wheels", *value, expected);
    bool areTeeth = true;
    value->forEachElement([&](JsonValue each, std::size_t /*position*/) {
      const auto teeth = each.is(JsonKind::number) ? Rational::fromText(each.slice()) : std::nullopt;
      areTeeth = areTeeth && teeth && teeth->isInteger() && *teeth >= Rational(1) &&
                 *teeth <= Rational(kMaxSearchedTeeth);
      if (areTeeth) m_wish.stock.push_back(static_cast<int>(teeth->toDouble()));
    });
    if (!areTeeth) return from.wrong("wheels", *value, expected);
    std::sort(m_wish.stock.begin(), m_wish.stock.end());
  }

  void readKept(JsonObject& from) {
    const auto names = from.ids("kept");
    if (!names) return;
    for (const InternedString& name : *names) {
      if (isGearName(name.text())) {
        m_wish.kept.push_back(name.text());
      } else if (!name.empty()) {
        fail("/kept", "kept",
             translated("There is no wheel \"%1\": wheels are named like 15:tail.", {name.text()}),
             Code::unknownId);
      }
    }
  }

  [[nodiscard]] bool isGearName(const std::string& name) const {
    for (MeshOrdinal mesh = 0; mesh < m_mechanism.c(); ++mesh) {
      const std::string label = std::to_string(m_mechanism.meshLabel(mesh));
      if (name == label + ":tail" || name == label + ":head") return true;
    }
    return false;
  }

  void readEfficiency(JsonObject& from) {
    const auto value = from.member("efficiency");
    if (!value) return;
    JsonObject one(m_found, *value, "/efficiency");
    if (!value->is(JsonKind::object)) return;
    const auto read = [&](std::string_view name) -> std::optional<Rational> {
      const auto member = one.member(name);
      if (!member) return std::nullopt;
      const auto number = fraction(one, name, *member, kEfficiency);
      if (number && (number->sign() <= 0 || *number > Rational(1))) one.wrong(name, *member, kEfficiency);
      return number;
    };
    const auto mesh = read("mesh");
    const auto set = read("set");
    m_wish.leastEfficiency = read("least").value_or(Rational(0));
    if (mesh && set)
      one.wrong("set", *value->member("set"), toTranslate("no efficiency of a set beside that of a mesh"));
    // In a set with its carrier held the power passes two meshes.
    if (set && set->sign() > 0)
      m_wish.efficiency = set->squareRoot().value_or(Rational::fromDouble(std::sqrt(set->toDouble())));
    if (mesh) m_wish.efficiency = *mesh;
    for (const auto& [name, text] : one.unknown())
      m_found.add(Code::schema, translated("There is no member \"%1\" in a wish.", {name}), {},
                  "/efficiency" + pointerStep(name), *value);
  }

  static constexpr std::string_view kTolerance = toTranslate("a relative tolerance from 0 to below 1");
  static constexpr std::string_view kEfficiency = toTranslate("an efficiency above 0 and at most 1");

  JsonDiagnostics m_found;
  const Mechanism& m_mechanism;
  JsonValue m_root;
  TeethWish m_wish;
};

}  // namespace

Expected<TeethWish> readTeethWish(std::string_view json, const Mechanism& mechanism) {
  const auto document = JsonDocument::parse(json);
  if (!document) return document.error();
  JsonDiagnostics twice(*document);
  checkJson(*document, twice);
  if (!twice.empty()) return twice.inOrder();
  return WishReader(*document, mechanism).run();
}

}  // namespace geargraph
