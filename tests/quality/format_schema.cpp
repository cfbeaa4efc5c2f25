#include <algorithm>
#include <array>
#include <vector>

#include "core/foundations/base/contract.h"
#include "core/mechanism/model/limits.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/model/notes.h"
#include "tests/quality/format_files.h"

namespace geargraph::test {
namespace {

const std::string kMaxList = std::to_string(kMaxListLength);
const std::string kMaxName = std::to_string(kMaxNameLength);

std::string jsonText(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '`') continue;  // of Markdown
    if (c == '"' || c == '\\') json += '\\';
    json += c;
  }
  return json + '"';
}

std::string reference(std::string_view definition) {
  return "\"$ref\": \"#/$defs/" + std::string(definition) + "\"";
}

std::string listOf(const std::string& item, std::size_t least, std::size_t most) {
  return "\"type\": \"array\", " + (least > 0 ? "\"minItems\": " + std::to_string(least) + ", " : "") +
         "\"maxItems\": " + std::to_string(most) + ", \"items\": {" + item + "}";
}

std::string definitionName(DocumentPart part) {
  return std::string(objectName(part));
}

bool isLimited(Measure measure) {
  return measure != Measure::none && measure != Measure::turn && measure != Measure::speed;
}

std::string numberType(const MemberInfo& info) {
  switch (info.range) {
    case NumberRange::positive:
      return reference("positive");
    case NumberRange::notNegative:
      return reference("notNegative");
    case NumberRange::efficiency:
      return reference("efficiency");
    case NumberRange::fraction:
      return reference("friction");
    case NumberRange::acuteAngle:
      return reference("acuteAngle");
    case NumberRange::any:
      return reference(isLimited(info.measure) ? "length" : "number");
  }
  GEARGRAPH_REQUIRE(false);
}

/// A number of JSON, in a view.
std::string measureType(const MemberInfo& info) {
  std::string type = R"("type": "number")";
  if (info.range == NumberRange::positive) type += R"(, "exclusiveMinimum": 0)";
  if (isLimited(info.measure)) type += R"(, "maximum": 1e15)";
  return type;
}

template <class Value, std::size_t count>
std::string choice(const std::array<Value, count>& values, std::string_view (*name)(Value)) {
  std::string names;
  for (const Value value : values) names += (names.empty() ? "" : ", ") + jsonText(name(value));
  return "\"enum\": [" + names + "]";
}

/// The texts that have rules of their own, by kind of object and name.
std::string textType(DocumentPart part, const MemberInfo& info) {
  if (part == DocumentPart::shape)
    return R"("type": "string", "minLength": 1, "maxLength": )" + kMaxName +
           R"json(, "pattern": "^(?![/\\\\])(?![A-Za-z]:)(?!([.]?[/\\\\])*[.][.]([/\\\\]|$))")json";
  if (part == DocumentPart::note)
    return R"("type": "string", "minLength": 1, "maxLength": )" + std::to_string(kMaxNoteLength);
  return info.value == MemberValue::shortText ? reference("shortText") : R"("type": "string")";
}

/// The members of the schema of one value, without its braces.
std::string typeOf(DocumentPart part, const MemberInfo& info) {
  switch (info.value) {
    case MemberValue::constant:
      return info.name == "format" ? R"("const": "geargraph")" : R"("enum": [1, 2])";
    case MemberValue::text:
    case MemberValue::shortText:
      return textType(part, info);
    case MemberValue::id:
    case MemberValue::reference:
      return reference("id");
    case MemberValue::references:
      if (part == DocumentPart::coupling) return listOf(reference("id"), 2, 2);  // of a clutch
      // In the document itself each is engaged once.
      return (part == DocumentPart::document ? "\"uniqueItems\": true, " : "") +
             listOf(reference("id"), 0, kMaxListLength);
    case MemberValue::flag:
      return R"("type": "boolean")";
    case MemberValue::teeth:
      return reference("teeth");
    case MemberValue::meshKind:
      return choice(std::array{MeshKind::external, MeshKind::internal, MeshKind::bevel, MeshKind::belt,
                               MeshKind::pins, MeshKind::rack, MeshKind::screw, MeshKind::crossedHelical,
                               MeshKind::worm, MeshKind::faceGear, MeshKind::hypoid},
                    meshKindName);
    case MemberValue::hand:
      return choice(std::array{Hand::right, Hand::left}, handName);
    case MemberValue::jointKind:
      return choice(std::array{JointKind::turning, JointKind::sliding}, jointKindName);
    case MemberValue::sharing:
      return choice(std::array{LoadSharing::none, LoadSharing::stiffness}, loadSharingName);
    case MemberValue::couplingKind:
      return R"("enum": ["brake", "clutch", "freewheel"])";
    case MemberValue::number:
      return numberType(info);
    case MemberValue::triple:
      return reference("triple");
    case MemberValue::inertia:
      return listOf(reference("length"), 6, 6);
    case MemberValue::ends:
      return listOf(R"("anyOf": [{"type": "null"}, {)" + reference("number") + "}]", 2, 2);
    case MemberValue::object:
      return reference(definitionName(info.part));
    case MemberValue::objects: {
      const std::size_t most = info.part == DocumentPart::note ? kMaxNotes : kMaxListLength;
      return listOf(reference(definitionName(info.part)), info.part == DocumentPart::link ? 1 : 0, most);
    }
    case MemberValue::places:
      return reference("places");
    case MemberValue::numbersOfLinks:
      return R"("type": "object", "additionalProperties": {"type": "integer", "minimum": 1, "maximum": )" +
             std::to_string(kMaxColorNumber) + "}";
    case MemberValue::place:
      return listOf(reference("coordinate"), 2, 2);
    case MemberValue::position:
      return listOf(reference("coordinate"), 3, 3);
    case MemberValue::measure:
      return measureType(info);
  }
  GEARGRAPH_REQUIRE(false);
}

std::string property(DocumentPart part, const MemberInfo& info) {
  std::string text = std::string(info.meaning);
  if (!unitOf(info.measure).empty()) text += " (" + std::string(unitOf(info.measure)) + ")";
  if (!info.fallback.empty()) text += ". Without it: " + std::string(info.fallback);
  return jsonText(info.name) + ": {" + typeOf(part, info) + ", \"description\": " + jsonText(text) + "}";
}

std::string propertyOf(DocumentPart part, std::string_view name) {
  const MemberInfo* const info = memberOf(part, name);
  GEARGRAPH_REQUIRE(info != nullptr);
  return property(part, *info);
}

std::string namesOf(const std::vector<std::string_view>& names) {
  std::string all;
  for (const std::string_view name : names) all += (all.empty() ? "" : ", ") + jsonText(name);
  return "[" + all + "]";
}

/// One of the forms of an object: what it has, and what it does not have beside it.
struct Form {
  std::vector<std::string_view> needed;
  std::vector<std::string_view> rejected = {};
  std::vector<std::string_view> optional = {};
  std::string constant = {};  ///< the property that tells the forms apart, if its value does
};

std::string formText(DocumentPart part, const Form& form, const std::string& indent) {
  std::string text = indent + "{\n" + indent + "  \"required\": " + namesOf(form.needed) + ",\n";
  if (form.rejected.size() == 1) {
    text += indent + "  \"not\": {\"required\": " + namesOf(form.rejected) + "},\n";
  } else if (!form.rejected.empty()) {
    std::string each;
    for (const std::string_view name : form.rejected)
      each += (each.empty() ? "" : ", ") + ("{\"required\": " + namesOf({name})) + "}";
    text += indent + "  \"not\": {\"anyOf\": [" + each + "]},\n";
  }
  text += indent + "  \"properties\": {\n";
  std::string properties = form.constant.empty() ? "" : indent + "    " + form.constant;
  const auto add = [&](std::string_view name) {
    properties += (properties.empty() ? "" : ",\n") + indent + "    " + propertyOf(part, name);
  };
  for (const std::string_view name : form.needed) add(name);
  for (const std::string_view name : form.optional) add(name);
  return text + properties + "\n" + indent + "  }\n" + indent + "}";
}

/// The forms of objects whose members depend on each other. Their members are properties of the forms.
std::vector<Form> formsOf(DocumentPart part) {
  switch (part) {
    case DocumentPart::coupling:
      return {{{"link"}, {}, {}, R"("kind": {"const": "brake"})"},
              {{"links"}, {}, {}, R"("kind": {"enum": ["clutch", "freewheel"]})"}};
    case DocumentPart::load:
      return {{{"joint", "torque"}, {"link"}},
              {{"link", "torque"}, {"joint", "force"}, {"axis"}},
              {{"link", "force", "point"}, {"joint", "torque"}}};
    case DocumentPart::balance:
      return {{{"joint"}, {"link"}}, {{"link"}, {"joint"}, {"axis"}}};
    default:
      return {};
  }
}

/// What cannot be said of a member alone.
std::string rulesOf(DocumentPart part) {
  switch (part) {
    case DocumentPart::document:
      return R"(,
  "allOf": [
    {
      "description": "Moving links need joints.",
      "anyOf": [{"properties": {"links": {"maxItems": 1}}}, {"required": ["turningJoints"]}]
    },
    {
      "description": "Joints need axes.",
      "anyOf": [{"properties": {"turningJoints": {"maxItems": 0}}}, {"required": ["axes"]}]
    }
  ])";
    case DocumentPart::link:
      return R"(,
      "anyOf": [
        {"required": ["mass"]},
        {"not": {"anyOf": [{"required": ["centerOfMass"]}, {"required": ["inertia"]}]}}
      ])";
    case DocumentPart::gearMesh:
      return R"(,
      "not": {"required": ["efficiency", "friction"]},
      "anyOf": [
        {"required": ["tailTeeth", "headTeeth"]},
        {"required": ["tailDiameter", "headDiameter"]},
        {"required": ["kind"], "properties": {"kind": {"enum": ["pins", "screw"]}}}
      ])";
    case DocumentPart::gearDefaults:
      return R"(,
      "not": {"required": ["efficiency", "friction"]})";
    default:
      return {};
  }
}

/// Members of the schema of an object, from "type" on.
std::string objectText(DocumentPart part, const std::string& indent) {
  const std::vector<Form> forms = formsOf(part);
  const auto isInForms = [&](std::string_view name) {
    for (const Form& form : forms) {
      for (const auto& names : {form.needed, form.optional}) {
        if (std::find(names.begin(), names.end(), name) != names.end()) return true;
      }
      if (form.constant.starts_with(jsonText(name))) return true;
    }
    return false;
  };
  std::vector<std::string_view> needed;
  std::string properties;
  for (const MemberInfo& info : membersOf(part)) {
    // Pins and belts with running diameters leave their teeth out: rulesOf().
    if (info.isNeeded && info.value != MemberValue::teeth) needed.push_back(info.name);
    if (!isInForms(info.name))
      properties += (properties.empty() ? "" : ",\n") + indent + "  " + property(part, info);
  }
  std::string text = indent + "\"type\": \"object\"";
  if (!needed.empty()) text += ",\n" + indent + "\"required\": " + namesOf(needed);
  if (!properties.empty()) text += ",\n" + indent + "\"properties\": {\n" + properties + "\n" + indent + "}";
  if (!forms.empty()) {
    std::string all;
    for (const Form& form : forms) all += (all.empty() ? "" : ",\n") + formText(part, form, indent + "  ");
    text += ",\n" + indent + "\"oneOf\": [\n" + all + "\n" + indent + "]";
  }
  return text + rulesOf(part);
}

/// The types of values that the members share.
constexpr const char* kValueTypes = R"json(    "shortText": {"type": "string", "maxLength": 1000},
    "id": {
      "description": "A whole number is read as its decimal digits.",
      "anyOf": [{"type": "string", "minLength": 1, "maxLength": 1000}, {"type": "integer"}]
    },
    "number": {
      "description": "Exact: a JSON number, or a string with a number or a fraction, \"22/7\".",
      "anyOf": [
        {"type": "number"},
        {
          "type": "string",
          "maxLength": 4300,
          "pattern": "^[+-]?([0-9]+/0*[1-9][0-9]*|([0-9]+([.][0-9]+)?|[.][0-9]+)([eE][+-]?[0-9]+)?)$"
        }
      ]
    },
    "length": {
      "description": "Lengths, coordinates and components of directions are at most 1e15 in size.",
      "allOf": [
        {"$ref": "#/$defs/number"},
        {"anyOf": [{"type": "string"}, {"type": "number", "minimum": -1e15, "maximum": 1e15}]}
      ]
    },
    "positive": {
      "allOf": [
        {"$ref": "#/$defs/length"},
        {
          "anyOf": [
            {"type": "number", "exclusiveMinimum": 0},
            {"type": "string", "pattern": "^[+]?([0.]*[1-9])"
}
          ]
          }
      ]
      },
    "notNegative": {
      "allOf": [
        {"$ref": "#/$defs/length"},
        {"anyOf": [{"type": "number", "minimum": 0}, {"type": "string", "pattern": "^[^-]"}]}
      ]
    },
    "efficiency": {
      "description": "Above 0, at most 1.",
      "allOf": [
        {"$ref": "#/$defs/number"},
        {
          "anyOf": [
            {"type": "number", "exclusiveMinimum": 0, "maximum": 1},
            {"type": "string", "pattern": "^[+]?([0.]*[1-9])"}
          ]
        }
      ]
    },
    "friction": {
      "description": "The coefficient of friction of the teeth, from 0 to 1.",
      "allOf": [
        {"$ref": "#/$defs/number"},
        {
          "anyOf": [
            {"type": "number", "minimum": 0, "maximum": 1},
            {"type": "string", "pattern": "^([+]|-[0.]*([eE/]|$)|[^-])"}
          ]
        }
      ]
    },
    "acuteAngle": {
      "description": "Degrees, at least 0, below 90.",
      "allOf": [
        {"$ref": "#/$defs/number"},
        {
          "anyOf": [
            {"type": "number", "minimum": 0, "exclusiveMaximum": 90},
            {"type": "string", "pattern": "^([+]|-[0.]*([eE/]|$)|[^-])"}
          ]
        }
      ]
    },
    "triple": {"type": "array", "minItems": 3, "maxItems": 3, "items": {"$ref": "#/$defs/length"}},
    "teeth": {"type": "integer", "minimum": 1, "maximum": 100000},
    "coordinate": {"type": "number", "minimum": -1e15, "maximum": 1e15},
    "places": {
      "description": "Centres of nodes by the id of their link, x to the right and y down.",
      "type": "object",
      "additionalProperties": {"type": "array", "minItems": 2, "maxItems": 2, "items": {"$ref": "#/$defs/coordinate"}}
    })json";

}  // namespace

std::string documentSchema() {
  std::string text = R"({
  "$schema": "https://json-schema.org/draft/2020-12/schema",
  "title": "GearGraph document",
  "description": "A geared mechanism, *.geargraph, version 1 or 2. README.md beside this file says what the members mean and which rules a schema cannot state: unique ids, references, a direction of length above 0. Members that are not named here are allowed everywhere and kept on saving.",
)" + objectText(DocumentPart::document, "  ") +
                     ",\n  \"$defs\": {\n" + kValueTypes;
  for (const DocumentPart part : documentParts()) {
    if (part == DocumentPart::document) continue;
    text += ",\n    " + jsonText(definitionName(part)) + ": {\n" + objectText(part, "      ") + "\n    }";
  }
  return text + "\n  }\n}\n";
}

}  // namespace geargraph::test
