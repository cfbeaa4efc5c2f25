#include "core/presentation/requests/edit_members.h"

#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/nearest_name.h"
#include "core/presentation/exporters/option_values.h"

namespace geargraph {
namespace {

const RequestMember* entryOf(std::span<const RequestMember> members, std::string_view name) {
  const auto found = std::find_if(members.begin(), members.end(),
                                  [&](const RequestMember& each) { return each.name == name; });
  return found == members.end() ? nullptr : &*found;
}

std::optional<Number> numberOf(const JsonValue& value) {
  if (value.is(JsonKind::string)) return Number::fromText(value.string());
  return value.is(JsonKind::number) ? Number::fromText(value.slice()) : std::nullopt;
}

}  // namespace

std::optional<std::string> unknownMember(std::string_view owner, const JsonValue& object,
                                         std::span<const RequestMember> known, std::string_view but) {
  std::optional<std::string> sentence;
  object.forEachMember([&](const JsonValue& key, const JsonValue& /*value*/) {
    const std::string name = key.string();
    if (sentence || name == but || entryOf(known, name) != nullptr) return;
    sentence = "\"" + std::string(owner) + "\" has no member \"" + name + "\".";
    std::vector<std::string_view> names;
    for (const RequestMember& member : known) names.push_back(member.name);
    if (const auto nearest = nearestName(name, names))
      *sentence += " Is \"" + std::string(*nearest) + "\" meant?";
  });
  return sentence;
}

std::string membersText(std::span<const RequestMember> members) {
  std::string text;
  for (const RequestMember& member : members) {
    if (!text.empty()) text += ", ";
    text += member.isNeeded ? std::string(member.name) : '[' + std::string(member.name) + ']';
  }
  return text;
}

void writeMembers(JsonWriter& json, std::span<const RequestMember> members) {
  json.beginArray();
  for (const RequestMember& member : members) {
    json.beginObject(JsonWriter::Layout::row);
    json.member("name", member.name);
    json.member("value", member.value);
    json.member("needed", member.isNeeded);
    json.endObject();
  }
  json.endArray();
}

bool EditMembers::isNeeded(std::string_view name) const {
  const RequestMember* const entry = entryOf(m_known, name);
  GEARGRAPH_REQUIRE(entry != nullptr);
  return entry->isNeeded;
}

std::optional<JsonValue> EditMembers::member(std::string_view name) {
  m_read.push_back(name);
  return m_edit.member(name);
}

bool EditMembers::isUnread(std::string_view name) const {
  return entryOf(m_known, name) != nullptr && std::find(m_read.begin(), m_read.end(), name) == m_read.end();
}

std::string EditMembers::text(std::string_view name) {
  const bool needed = isNeeded(name);
  const auto value = member(name);
  if (value && value->is(JsonKind::string)) return value->string();
  if (value && value->is(JsonKind::number)) return std::string(value->slice());
  if (value || needed) wrong(name, "a text");
  return {};
}

int EditMembers::whole(std::string_view name) {
  const auto number = numberFrom<int>(text(name));
  if (!number) wrong(name, "a whole number");
  return number.value_or(0);
}

std::vector<std::string> EditMembers::texts(std::string_view name) {
  std::vector<std::string> list;
  const bool needed = isNeeded(name);
  const auto value = member(name);
  if (!value && !needed) return list;
  if (!value || !value->is(JsonKind::array)) {
    wrong(name, "a list of texts");
    return list;
  }
  value->forEachElement([&](const JsonValue& each, std::size_t /*position*/) {
    each.is(JsonKind::string) ? list.push_back(each.string()) : wrong(name, "a list of texts");
  });
  return list;
}

std::optional<NumberTriple> EditMembers::triple(std::string_view name) {
  const auto value = member(name);
  if (!value || value->is(JsonKind::null)) return std::nullopt;
  NumberTriple triple;
  bool isFine = value->is(JsonKind::array) && value->size() == triple.size();
  for (std::size_t i = 0; isFine && i < triple.size(); ++i) {
    const auto number = numberOf(*value->element(i));
    isFine = number.has_value();
    if (number) triple.at(i) = *number;
  }
  if (!isFine) wrong(name, "a list of three numbers");
  return triple;
}

std::vector<Input> EditMembers::inputs(std::string_view name) {
  std::vector<Input> inputs;
  const auto value = member(name);
  if (!value || !value->is(JsonKind::array)) {
    wrong(name, "a list of inputs");
    return inputs;
  }
  value->forEachElement([&](const JsonValue& each, std::size_t /*position*/) {
    const auto joint = each.is(JsonKind::object) ? each.member("joint") : std::nullopt;
    const auto speed = each.is(JsonKind::object) ? each.member("speed") : std::nullopt;
    const auto number = speed ? numberOf(*speed) : std::nullopt;
    if (!joint || !joint->is(JsonKind::string) || !number || each.size() != 2)
      return wrong(name, "a list of inputs, each with \"joint\" and \"speed\"");
    inputs.push_back({JointId(joint->string()), *number, {}});
  });
  return inputs;
}

void EditMembers::wrong(std::string_view name, std::string_view expected) {
  if (m_problem) return;
  m_problem = Diagnostic{Code::schema,
                         "The member \"" + std::string(name) + "\" has to be " + std::string(expected) + ".",
                         {},
                         m_pointer};
}

}  // namespace geargraph
