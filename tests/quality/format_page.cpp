#include "core/foundations/base/contract.h"
#include "tests/quality/format_files.h"

namespace geargraph::test {
namespace {

std::string nameOfKind(ElementKind kind) {
  switch (kind) {
    case ElementKind::link:
      return "a link";
    case ElementKind::axis:
      return "an axis";
    case ElementKind::turningJoint:
      return "a turning joint";
    case ElementKind::gearMesh:
      return "a gear mesh";
    case ElementKind::wheel:
      return "a wheel";
    case ElementKind::coupling:
      return "a coupling";
    default:
      return "an element";
  }
}

std::string rangeText(NumberRange range) {
  switch (range) {
    case NumberRange::any:
      return "";
    case NumberRange::positive:
      return ", above 0";
    case NumberRange::notNegative:
      return ", at least 0";
    case NumberRange::efficiency:
      return ", above 0, at most 1";
    case NumberRange::fraction:
      return ", from 0 to 1";
    case NumberRange::acuteAngle:
      return ", at least 0, below 90";
  }
  GEARGRAPH_REQUIRE(false);
}

std::string unitText(const MemberInfo& info) {
  const std::string_view unit = unitOf(info.measure);
  return (unit.empty() ? "" : ", " + std::string(unit)) + rangeText(info.range);
}

std::string valueText(const MemberInfo& info) {
  switch (info.value) {
    case MemberValue::constant:
      return "";
    case MemberValue::text:
      return "text";
    case MemberValue::shortText:
      return "text of at most 1,000 characters";
    case MemberValue::id:
      return "id";
    case MemberValue::reference:
      return "id of " + nameOfKind(info.target);
    case MemberValue::references: {
      const std::string one = nameOfKind(info.target);
      return "ids of " + one.substr(one.find(' ') + 1) + "s";
    }
    case MemberValue::flag:
      return "`true` or `false`";
    case MemberValue::teeth:
      return "whole number from 1 to 100,000";
    case MemberValue::meshKind:
      return "`external`, `internal`, `bevel`, `belt`, `pins`, `rack`, `screw`, `crossedHelical`, `worm`, "
             "`faceGear` or `hypoid`";
    case MemberValue::hand:
      return "`right` or `left`";
    case MemberValue::jointKind:
      return "`turning` or `sliding`";
    case MemberValue::couplingKind:
      return "`brake` or `clutch`";
    case MemberValue::sharing:
      return "`stiffness` or `none`";
    case MemberValue::number:
    case MemberValue::measure:
      return "number" + unitText(info);
    case MemberValue::triple:
    case MemberValue::position:
      return "three numbers" + unitText(info);
    case MemberValue::inertia:
      return "six numbers" + unitText(info);
    case MemberValue::ends:
      return "two of number or `null`" + unitText(info);
    case MemberValue::object:
      return "object, below";
    case MemberValue::objects:
      return "list of objects, below";
    case MemberValue::places:
      return "object of `[x, y]` by id of a link";
    case MemberValue::numbersOfLinks:
      return "object of whole numbers from 1 to 1,000,000 by id of a link";
    case MemberValue::place:
      return "`[x, y]`";
  }
  GEARGRAPH_REQUIRE(false);
}

std::string rowOf(const MemberInfo& info) {
  std::string meaning(info.meaning);
  if (info.since > 1) meaning += "; since version " + std::to_string(info.since);
  const std::string without = info.isNeeded ? "needed" : std::string(info.fallback);
  return "| `" + std::string(info.name) + "` | " + valueText(info) + " | " + meaning + " | " + without +
         " |\n";
}

}  // namespace

std::string memberTables() {
  std::string text;
  for (const DocumentPart part : documentParts()) {
    const std::string name(partName(part));
    if (!text.empty()) text += "\n";
    text += (name.empty() ? std::string("The document") : "`" + name + "`") + ":\n\n";
    text += "| member | value | meaning | without it |\n| --- | --- | --- | --- |\n";
    for (const MemberInfo& info : membersOf(part)) text += rowOf(info);
  }
  return text;
}

}  // namespace geargraph::test
