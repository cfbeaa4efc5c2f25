#pragma once

#include <vector>

#include "core/mechanism/document_format/json_object.h"

namespace geargraph::inline document_format {

// The members of one element of a document, except its id: one description for the reader of documents and
// for edits that are given as JSON (element_members.h). Each call reads the members that the element has;
// what remains is JsonObject::unknown().

void readMembers(JsonObject& from, Link& link);
void readMembers(JsonObject& from, Axis& axis);
void readMembers(JsonObject& from, TurningJoint& joint);
void readMembers(JsonObject& from, GearMesh& mesh);
void readMembers(JsonObject& from, Wheel& wheel);
/// A coupling that could not be read has no links.
void readMembers(JsonObject& from, Coupling& coupling);
void readMembers(JsonObject& from, ShiftState& state);
void readMembers(JsonObject& from, Load& load);
void readMembers(JsonObject& from, Balance& balance);
void readMembers(JsonObject& from, GearDefaults& defaults);

}  // namespace geargraph::inline document_format
