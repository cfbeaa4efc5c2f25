#include "core/mechanism/model/member_info.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/foundations/base/contract.h"
#include "core/mechanism/model/fields.h"

namespace geargraph {
namespace {

/// Calls visit(Element*) for each described class; the pointers are null.
template <class Visit>
constexpr void forEachDescribed(const Visit& visit) {
  const auto each = [&]<class... Elements>(const std::tuple<Elements...>* /*none*/) {
    (visit(static_cast<Elements*>(nullptr)), ...);
  };
  each(static_cast<const DescribedClasses*>(nullptr));
}

template <class Element>
constexpr std::size_t headCount() {
  if constexpr (requires { Description<Element>::head; }) {
    return Description<Element>::head.size();
  } else {
    return 0;
  }
}

/// The members of a class, one after another, with its fields in this order.
template <class Element, class Order>
constexpr auto flatMembers(const Order& order) {
  constexpr auto& fields = Description<Element>::fields;
  constexpr std::size_t count = std::apply(
      [](const auto&... each) { return (std::remove_cvref_t<decltype(each)>::kCount + ...); }, fields);
  std::array<MemberInfo, headCount<Element>() + count> all{};
  std::size_t at = 0;
  if constexpr (headCount<Element>() > 0) {
    for (const MemberInfo& info : Description<Element>::head) all[at++] = info;
  }
  for (const std::size_t position : order) {
    std::size_t i = 0;
    forEachField<Element>([&](const auto& field) {
      if (i++ != position) return;
      for (const MemberInfo& info : field.infos) all[at++] = info;
    });
  }
  return all;
}

template <class Element>
constexpr auto fileOrder() {
  auto order = listedOrder<Element>();
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  return order;
}

template <class Element>
constexpr auto kMembers = flatMembers<Element>(fileOrder<Element>());
template <class Element>
constexpr auto kListed = flatMembers<Element>(listedOrder<Element>());

struct PartMembers {
  DocumentPart part = DocumentPart::document;
  std::string_view name;
  std::span<const MemberInfo> inFiles;
  std::span<const MemberInfo> listed;
  std::vector<std::string_view> names = {};
  std::string path = {};
};

/// The path to objects of this kind, by the members that hold them.
std::string pathTo(DocumentPart part, const std::vector<PartMembers>& all) {
  for (const PartMembers& around : all) {
    for (const MemberInfo& info : around.inFiles) {
      const bool holds = info.value == MemberValue::object || info.value == MemberValue::objects;
      if (!holds || info.part != part) continue;
      const std::string path = pathTo(around.part, all);
      return path.empty() ? std::string(info.name) : path + "/" + std::string(info.name);
    }
  }
  return {};
}

const std::vector<PartMembers>& allParts() {
  static const std::vector<PartMembers> all = [] {
    std::vector<PartMembers> parts;
    forEachDescribed([&]<class Element>(Element* /*none*/) {
      parts.push_back(
          {Description<Element>::part, Description<Element>::name, kMembers<Element>, kListed<Element>});
    });
    for (PartMembers& part : parts) {
      for (const MemberInfo& info : part.inFiles) part.names.push_back(info.name);
      part.path = pathTo(part.part, parts);
    }
    return parts;
  }();
  return all;
}

const PartMembers& entryOf(DocumentPart part) {
  const PartMembers& entry = allParts().at(static_cast<std::size_t>(part));
  GEARGRAPH_REQUIRE(entry.part == part);
  return entry;
}

}  // namespace

std::string_view unitOf(Measure measure) {
  switch (measure) {
    case Measure::none:
    case Measure::number:
    case Measure::coordinate:
    case Measure::length:
    case Measure::component:
      return "";
    case Measure::modules:
      return "modules";
    case Measure::angle:
    case Measure::turn:
      return "degrees";
    case Measure::speed:
      return "rad/s";
    case Measure::acceleration:
      return "m/s2";
    case Measure::density:
      return "kg/m3";
    case Measure::mass:
      return "kg";
    case Measure::moment:
      return "kg m2";
    case Measure::torque:
      return "N m";
    case Measure::force:
      return "N";
  }
  GEARGRAPH_REQUIRE(false);
}

std::span<const MemberInfo> membersOf(DocumentPart part) {
  return entryOf(part).inFiles;
}

std::span<const MemberInfo> listedMembersOf(DocumentPart part) {
  return entryOf(part).listed;
}

std::span<const std::string_view> memberNames(DocumentPart part) {
  return entryOf(part).names;
}

const MemberInfo* memberOf(DocumentPart part, std::string_view name) {
  const std::span<const MemberInfo> members = membersOf(part);
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const MemberInfo& info) { return info.name == name; });
  return found == members.end() ? nullptr : &*found;
}

std::string_view objectName(DocumentPart part) {
  return entryOf(part).name;
}

std::string_view partName(DocumentPart part) {
  return entryOf(part).path;
}

std::span<const DocumentPart> documentParts() {
  static const std::vector<DocumentPart> parts = [] {
    std::vector<DocumentPart> all;
    for (const PartMembers& each : allParts()) all.push_back(each.part);
    return all;
  }();
  return parts;
}

}  // namespace geargraph
