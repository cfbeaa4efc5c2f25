#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/mechanism/document_format/json_object.h"
#include "core/mechanism/model/member_info.h"

namespace geargraph {

/// Reads the members of one object of a document, as its class is described (fields.h), except the id of an
/// element: for the reader of documents and for edits that are given as JSON (element_members.h). What
/// remains is JsonObject::unknown(). A coupling that could not be read has no links.
///
/// `Element` is Link, LinkShape, Axis, TurningJoint, GearMesh, Wheel, GearDefaults, Input, Coupling,
/// ShiftState, Load, Balance, CanvasNote or ViewCamera.
template <class Element>
void readMembers(JsonObject& from, Element& element);

/// A JSON number that is finite as a double; std::nullopt for anything else.
[[nodiscard]] std::optional<double> finiteNumber(JsonValue value);
/// The coordinates of a list of `count` finite numbers; std::nullopt for anything else.
template <std::size_t count>
[[nodiscard]] std::optional<std::array<double, count>> coordinatesOf(JsonValue value);

/// Reads one member of an object into a value of the class that is described with it.
void readValue(JsonObject& from, const MemberInfo& info, std::string& value);
void readValue(JsonObject& from, const MemberInfo& info, std::optional<Number>& value);
void readValue(JsonObject& from, const MemberInfo& info, std::optional<NumberTriple>& value);
void readValue(JsonObject& from, const MemberInfo& info, std::optional<LoadSharing>& value);
void readValue(JsonObject& from, const MemberInfo& info, std::vector<ShiftElementId>& value);

}  // namespace geargraph
