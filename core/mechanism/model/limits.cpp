#include "core/mechanism/model/limits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/translation.h"
#include "core/mechanism/model/fields.h"
#include "core/mechanism/model/notes.h"

namespace geargraph {
namespace {

/// Characters of a text in UTF-8.
std::size_t characterCount(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & '\xC0') != '\x80'; }));
}

bool isTooLong(const std::string& text) {
  return text.size() > kMaxNameLength && characterCount(text) > kMaxNameLength;  // bytes are at least as many
}

std::string pointerIn(std::string_view list, std::size_t position, const char* member) {
  return "/" + std::string(list) + "/" + std::to_string(position) + "/" + member;
}

Diagnostic makeDiagnostic(std::string message, std::string pointer, std::vector<ElementId> elements = {}) {
  return {Code::schema, std::move(message), std::move(elements), std::move(pointer), 0, 0};
}

Diagnostic tooLong(const std::string& text, std::string pointer, std::vector<ElementId> elements = {}) {
  return makeDiagnostic(translated("A name has at most 1,000 characters; this one has %1.",
                                   {std::to_string(characterCount(text))}),
                        std::move(pointer), std::move(elements));
}

void checkLength(std::size_t size, std::string_view name, Diagnostics& diagnostics) {
  if (size <= kMaxListLength) return;
  const std::string list(name);
  diagnostics.push_back(makeDiagnostic(
      translated("A document has at most 100,000 %1; this one has %2.", {list, std::to_string(size)}),
      "/" + list));
}

template <class Element>
void checkIds(const std::vector<Element>& list, std::string_view name, Diagnostics& diagnostics) {
  if constexpr (requires(const Element& element) { ElementId(element.id); }) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string& id = list[i].id.text();
      if (isTooLong(id)) diagnostics.push_back(tooLong(id, pointerIn(name, i, "id"), {list[i].id}));
    }
  }
}

/// A list of the document, which may be left out.
template <class Value>
void checkList(const Value& value, const MemberInfo& info, Diagnostics& diagnostics) {
  if constexpr (DescribedList<Value>) {
    checkLength(value.size(), info.name, diagnostics);
    checkIds(value, info.name, diagnostics);
  }
}
void checkList(const std::vector<ShiftElementId>& value, const MemberInfo& info, Diagnostics& diagnostics) {
  checkLength(value.size(), info.name, diagnostics);
}
template <class Value>
void checkList(const std::optional<Value>& value, const MemberInfo& info, Diagnostics& diagnostics) {
  if (value) checkList(*value, info, diagnostics);
}

/// The short texts of an object, and of what its lists hold. `pointer` gives its JSON pointer, for those that
/// are too long only.
template <class Object, class Pointer>
void checkTexts(const Object& object, const Pointer& pointer, Diagnostics& diagnostics) {
  forEachField<Object>([&]<class Member>(const Member& field) {
    if constexpr (std::is_same_v<typename Member::Value, std::string>) {
      const std::string& text = object.*field.member;
      if (field.info().value != MemberValue::shortText || !isTooLong(text)) return;
      std::vector<ElementId> elements;
      if constexpr (requires { ElementId(object.id); }) elements.push_back(object.id);
      diagnostics.push_back(tooLong(text, pointer() + "/" + std::string(field.info().name), elements));
    } else if constexpr (DescribedList<typename Member::Value>) {
      const auto& list = object.*field.member;
      for (std::size_t i = 0; i < list.size(); ++i) {
        checkTexts(
            list[i],
            [&] { return pointer() + "/" + std::string(field.info().name) + "/" + std::to_string(i); },
            diagnostics);
      }
    }
  });
}

/// A JSON pointer that is written only where a number is beyond its range: writing those of all numbers would
/// take longer than comparing them. It refers to the one that it was made from.
class JsonPointer {
 public:
  JsonPointer() = default;  ///< the document
  [[nodiscard]] JsonPointer operator/(std::string_view member) const { return {this, member, {}}; }
  [[nodiscard]] JsonPointer operator/(std::size_t position) const { return {this, {}, position}; }

  [[nodiscard]] std::string text() const {
    if (m_of == nullptr) return {};
    return m_of->text() + "/" + (m_position ? std::to_string(*m_position) : std::string(m_member));
  }

 private:
  JsonPointer(const JsonPointer* of, std::string_view member, std::optional<std::size_t> position)
      : m_of(of), m_member(member), m_position(position) {}

  const JsonPointer* m_of = nullptr;
  std::string_view m_member;
  std::optional<std::size_t> m_position;  ///< in a list, instead of a member
};

/// Collects lengths beyond their range. Doubles decide: the limit is a power of ten that both kinds hold.
class RangeCheck {
 public:
  explicit RangeCheck(const Mechanism& mechanism) {
    forEachField<Mechanism>([&](const auto& field) {
      list(mechanism.*field.member, field.info().name);
      value(mechanism.*field.member, field, std::nullopt, JsonPointer());
    });
  }

  Diagnostics found;

 private:
  using Element = std::optional<ElementId>;
  static constexpr double kMax = static_cast<double>(kLargestLength);

  /// Null for what has no limit.
  static const char* sentenceFor(Measure measure) {
    switch (measure) {
      case Measure::none:
      case Measure::turn:
      case Measure::speed:
        return nullptr;
      case Measure::number:
      case Measure::modules:
      case Measure::angle:
        return toTranslate("expected a number from -1e15 to 1e15.");
      case Measure::coordinate:
        return toTranslate("expected a coordinate from -1e15 to 1e15.");
      case Measure::component:
      case Measure::acceleration:
        return toTranslate("expected a component from -1e15 to 1e15.");
      case Measure::length:
        return toTranslate("expected a length from -1e15 to 1e15.");
      case Measure::density:
        return toTranslate("expected a density from -1e15 to 1e15.");
      case Measure::mass:
        return toTranslate("expected a mass from -1e15 to 1e15.");
      case Measure::moment:
        return toTranslate("expected a moment from -1e15 to 1e15.");
      case Measure::torque:
        return toTranslate("expected a torque from -1e15 to 1e15.");
      case Measure::force:
        return toTranslate("expected a force from -1e15 to 1e15.");
    }
    return nullptr;
  }

  static bool isWithin(double value) { return std::abs(value) <= kMax; }
  void number(const Element& element, double value, Measure measure, const JsonPointer& pointer) {
    if (isWithin(value)) return;
    const char* const sentence = sentenceFor(measure);
    if (sentence == nullptr) return;
    std::vector<ElementId> elements;
    if (element) elements.push_back(*element);
    found.push_back(makeDiagnostic(translated(sentence), pointer.text(), std::move(elements)));
  }
  template <std::size_t count>
  void numbers(const Element& element, const std::array<Number, count>& values, Measure measure,
               const JsonPointer& pointer) {
    for (std::size_t i = 0; i < count; ++i) number(element, values[i].value(), measure, pointer / i);
  }

  template <class Value>
  void list(const Value& value, std::string_view name) {
    if constexpr (DescribedList<Value>) {
      const JsonPointer document, all = document / name;
      for (std::size_t i = 0; i < value.size(); ++i) {
        Element element;
        if constexpr (requires { ElementId(value[i].id); }) element = value[i].id;
        object(value[i], element, all / i);
      }
    }
  }
  template <class Object>
  void object(const Object& object, const Element& element, const JsonPointer& at) {
    forEachField<Object>([&](const auto& field) { value(object.*field.member, field, element, at); });
    if constexpr (std::is_same_v<Object, Axis>) {
      if (object.direction) notTooShort(object, at / "direction");
    }
  }

  // The value of a member, by its type. The others have no numbers with limits.

  template <class Value, class Member>
  void value(const Value& /*value*/, const Member& /*field*/, const Element& /*element*/,
             const JsonPointer& /*at*/) {}
  template <class Member>
  void value(const Number& one, const Member& field, const Element& element, const JsonPointer& at) {
    number(element, one.value(), field.info().measure, at / field.info().name);
  }
  template <class Member>
  void value(const NumberTriple& three, const Member& field, const Element& element, const JsonPointer& at) {
    numbers(element, three, field.info().measure, at / field.info().name);
  }
  template <class Value, class Member>
  void value(const std::optional<Value>& given, const Member& field, const Element& element,
             const JsonPointer& at) {
    if (given) value(*given, field, element, at);
  }
  template <class Member>
  void value(const GearDefaults& defaults, const Member& field, const Element& element,
             const JsonPointer& at) {
    object(defaults, element, at / field.info().name);
  }
  template <class Member>
  void value(const std::vector<LinkShape>& shapes, const Member& field, const Element& element,
             const JsonPointer& at) {
    const JsonPointer all = at / field.info().name;
    for (std::size_t k = 0; k < shapes.size(); ++k) object(shapes[k], element, all / k);
  }
  template <class Member>
  void value(const SharedOptional<LinkMass>& mass, const Member& field, const Element& element,
             const JsonPointer& at) {
    if (!mass) return;
    const auto& [stated, center, inertia] = field.infos;
    number(element, mass->mass.value(), stated.measure, at / stated.name);
    if (mass->center) numbers(element, *mass->center, center.measure, at / center.name);
    if (mass->inertia) numbers(element, *mass->inertia, inertia.measure, at / inertia.name);
  }
  template <class Member>
  void value(const decltype(Load::action)& action, const Member& field, const Element& /*load*/,
             const JsonPointer& at) {
    const MemberInfo& torqueInfo = field.infos[kActionTorque];
    if (const auto* inJoint = std::get_if<JointTorque>(&action)) {
      number(inJoint->joint, inJoint->torque.value(), torqueInfo.measure, at / torqueInfo.name);
    } else if (const auto* torque = std::get_if<LinkTorque>(&action)) {
      number(torque->link, torque->torque.value(), torqueInfo.measure, at / torqueInfo.name);
    } else {
      const auto& force = std::get<LinkForce>(action);
      const MemberInfo& forceInfo = field.infos[kActionForce];
      const MemberInfo& pointInfo = field.infos[kActionPoint];
      numbers(force.link, force.force, forceInfo.measure, at / forceInfo.name);
      numbers(force.link, force.point, pointInfo.measure, at / pointInfo.name);
    }
  }
  template <class Member>
  void value(const View& view, const Member& field, const Element& element, const JsonPointer& at) {
    object(view, element, at / field.info().name);
  }
  template <class Member>
  void value(const std::map<LinkId, CanvasPoint>& nodes, const Member& field, const Element& /*none*/,
             const JsonPointer& at) {
    const JsonPointer all = at / field.info().name;
    for (const auto& [link, place] : nodes) {
      if (isWithin(place.x) && isWithin(place.y)) continue;
      const std::string name = link.text();
      const JsonPointer node = all / name;
      number(link, place.x, field.info().measure, node / 0);
      number(link, place.y, field.info().measure, node / 1);
    }
  }
  template <class Member>
  void value(const ViewCamera& camera, const Member& field, const Element& element, const JsonPointer& at) {
    object(camera, element, at / field.info().name);
  }
  template <class Member>
  void value(const std::array<double, 3>& position, const Member& field, const Element& element,
             const JsonPointer& at) {
    const JsonPointer all = at / field.info().name;
    for (std::size_t i = 0; i < position.size(); ++i)
      number(element, position[i], field.info().measure, all / i);
  }
  template <class Member>
  void value(double measure, const Member& field, const Element& element, const JsonPointer& at) {
    number(element, measure, field.info().measure, at / field.info().name);
  }

  void notTooShort(const Axis& axis, const JsonPointer& pointer) {
    double longest = 0;
    for (const Number& component : *axis.direction) longest = std::max(longest, std::abs(component.value()));
    if (longest >= 1 / kMax || isZero(*axis.direction))
      return;  // that of length 0 has a diagnostic of its own
    found.push_back(makeDiagnostic(translated("expected a direction with a component of at least 1e-15."),
                                   pointer.text(), {axis.id}));
  }
};

}  // namespace

Diagnostics limitDiagnostics(const Mechanism& mechanism) {
  Diagnostics diagnostics;
  checkTexts(
      mechanism, [] { return std::string(); }, diagnostics);
  forEachField<Mechanism>(
      [&](const auto& field) { checkList(mechanism.*field.member, field.info(), diagnostics); });
  append(diagnostics, noteDiagnostics(mechanism));
  const Diagnostics beyond = RangeCheck(mechanism).found;
  diagnostics.insert(diagnostics.end(), beyond.begin(), beyond.end());
  return diagnostics;
}

Expected<Mechanism> checkedLimits(Mechanism mechanism) {
  Diagnostics beyond = limitDiagnostics(mechanism);
  if (beyond.empty()) return mechanism;
  for (Diagnostic& diagnostic : beyond) diagnostic.pointer.clear();
  return beyond;
}

}  // namespace geargraph
