#include "core/io/view_places.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "core/io/json.h"

namespace geargraph {
namespace {

std::string numberText(double value) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return std::string(text.data(), end.ptr);
}

std::string textOf(const ViewPlaces& places) {
  std::string json = "{";
  for (const auto& [link, place] : places) {
    if (json.size() > 1) json += ", ";
    appendJsonString(json, link.text());
    json += ": [" + numberText(place.x) + ", " + numberText(place.y) + "]";
  }
  return json + "}";
}

std::optional<SheetPoint> placeOf(JsonValue value) {
  if (!value.is(JsonKind::array) || value.size() != 2) return std::nullopt;
  std::vector<double> coordinates;
  value.forEachElement([&](JsonValue element, std::size_t) {
    const auto number = element.is(JsonKind::number) ? Number::fromText(element.slice()) : std::nullopt;
    if (number) coordinates.push_back(number->value());
  });
  if (coordinates.size() != 2) return std::nullopt;
  return SheetPoint{coordinates[0], coordinates[1]};
}

}  // namespace

ViewPlaces viewPlaces(const Mechanism& mechanism, std::string_view member) {
  ViewPlaces places;
  for (const auto& [name, text] : mechanism.view.unknown) {
    if (name != member) continue;
    const Expected<JsonDocument> document = JsonDocument::parse(text);
    if (!document || !document->root().is(JsonKind::object)) continue;
    document->root().forEachMember([&](JsonValue key, JsonValue value) {
      const LinkId link(key.string());
      const std::optional<SheetPoint> place = placeOf(value);
      if (place && mechanism.find(link) != nullptr) places[link] = *place;
    });
  }
  return places;
}

Expected<Mechanism> withViewPlaces(Mechanism mechanism, std::string_view member,
                                   const std::vector<std::pair<LinkId, SheetPoint>>& places) {
  ViewPlaces all = viewPlaces(mechanism, member);
  for (const auto& [link, place] : places) {
    if (mechanism.find(link) == nullptr) {
      Diagnostic refusal;
      refusal.code = Code::unknownId;
      refusal.message = "There is no link \"" + link.text() + "\".";
      return refusal;
    }
    all[link] = place;
  }
  UnknownMembers& members = mechanism.view.unknown;
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const auto& entry) { return entry.first == member; });
  if (found == members.end()) {
    members.emplace_back(member, textOf(all));
  } else {
    found->second = textOf(all);
  }
  return mechanism;
}

Mechanism withoutLostPlaces(Mechanism mechanism, std::string_view member) {
  for (auto& [name, text] : mechanism.view.unknown) {
    if (name != member) continue;
    const Expected<JsonDocument> document = JsonDocument::parse(text);
    if (!document || !document->root().is(JsonKind::object)) continue;
    bool anyLost = false;
    document->root().forEachMember([&](JsonValue key, JsonValue) {
      anyLost = anyLost || mechanism.find(LinkId(key.string())) == nullptr;
    });
    if (anyLost) text = textOf(viewPlaces(mechanism, member));
  }
  return mechanism;
}

Mechanism withoutViewPlaces(Mechanism mechanism, std::string_view member) {
  std::erase_if(mechanism.view.unknown, [&](const auto& entry) { return entry.first == member; });
  return mechanism;
}

}  // namespace geargraph
