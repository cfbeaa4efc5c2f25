#include "core/mechanism/document_format/graph_members.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/mechanism/model/member_info.h"

namespace geargraph {
namespace {

struct PartEntry {
  GraphPart part;
  DocumentPart objects;
};
constexpr std::array kGraphParts = {PartEntry{GraphPart::graph, DocumentPart::document},
                                    PartEntry{GraphPart::node, DocumentPart::link},
                                    PartEntry{GraphPart::turningEdge, DocumentPart::turningJoint},
                                    PartEntry{GraphPart::meshEdge, DocumentPart::gearMesh}};

MemberType typeOf(MemberValue value) {
  switch (value) {
    case MemberValue::text:
    case MemberValue::shortText:
    case MemberValue::meshKind:
    case MemberValue::hand:
    case MemberValue::jointKind:
    case MemberValue::couplingKind:
    case MemberValue::sharing:
      return MemberType::text;
    case MemberValue::id:
    case MemberValue::reference:
      return MemberType::id;
    case MemberValue::teeth:
    case MemberValue::number:
    case MemberValue::measure:
      return MemberType::number;
    case MemberValue::flag:
      return MemberType::flag;
    default:
      return MemberType::json;
  }
}

/// By part; from the description of the document.
const std::vector<GraphMember>& graphMembers() {
  static const std::vector<GraphMember> all = [] {
    std::vector<GraphMember> members;
    for (const PartEntry& entry : kGraphParts) {
      for (const MemberInfo& info : membersOf(entry.objects)) {
        if (!info.isInGraphs) continue;
        const std::string_view attribute = info.attribute.empty() ? info.name : info.attribute;
        members.push_back({entry.part, attribute, info.name, typeOf(info.value)});
      }
    }
    return members;
  }();
  return all;
}

template <class Matches>
const GraphMember* found(Matches matches) {
  const std::vector<GraphMember>& members = graphMembers();
  const auto at = std::find_if(members.begin(), members.end(), matches);
  return at == members.end() ? nullptr : &*at;
}

}  // namespace

const GraphMember* graphMemberOf(GraphPart part, std::string_view member) {
  return found([&](const GraphMember& each) { return each.part == part && each.member == member; });
}

const GraphMember* graphAttributeOf(GraphPart part, std::string_view attribute) {
  return found([&](const GraphMember& each) { return each.part == part && each.attribute == attribute; });
}

std::optional<std::string_view> knownAttribute(AttributeOwner owner, std::string_view name) {
  const auto isOf = [&](GraphPart part) {
    switch (owner) {
      case AttributeOwner::graph:
        return part == GraphPart::graph;
      case AttributeOwner::node:
        return part == GraphPart::node;
      case AttributeOwner::edge:
        return part == GraphPart::turningEdge || part == GraphPart::meshEdge;
    }
    return false;
  };
  if (const auto* known =
          found([&](const GraphMember& each) { return isOf(each.part) && each.attribute == name; }))
    return known->attribute;
  if (owner == AttributeOwner::graph && name == kVersionAttribute) return kVersionAttribute;
  if (name == kLabel) return kLabel;
  if (owner == AttributeOwner::edge && name == kEdgeKind) return kEdgeKind;
  return std::nullopt;
}

}  // namespace geargraph
