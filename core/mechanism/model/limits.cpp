#include "core/mechanism/model/limits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/words.h"
#include "core/mechanism/model/element_pointer.h"
#include "core/mechanism/model/notes.h"

namespace geargraph::inline model {
namespace {

/// Characters of a text in UTF-8.
std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & '\xC0') != '\x80'; }));
}

bool isTooLong(const std::string& text) {
  return text.size() > kMaxNameLength && characters(text) > kMaxNameLength;  // bytes are at least as many
}

std::string pointerTo(ElementKind list, std::size_t position, const char* member) {
  return pointerTo(list, position) + "/" + member;
}

Diagnostic makeDiagnostic(std::string message, std::string pointer, std::vector<ElementId> elements = {}) {
  return {Code::schema, std::move(message), std::move(elements), std::move(pointer), 0, 0};
}

Diagnostic tooLong(const std::string& text, std::string pointer, std::vector<ElementId> elements = {}) {
  return makeDiagnostic(
      translated("A name has at most 1,000 characters; this one has %1.", {std::to_string(characters(text))}),
      std::move(pointer), std::move(elements));
}

void checkLength(std::size_t size, const std::string& name, Diagnostics& diagnostics) {
  if (size <= kMaxListLength) return;
  diagnostics.push_back(makeDiagnostic(
      translated("A document has at most 100,000 %1; this one has %2.", {name, std::to_string(size)}),
      "/" + name));
}

void checkLength(std::size_t size, ElementKind kind, Diagnostics& diagnostics) {
  checkLength(size, std::string(listName(kind)), diagnostics);
}

template <class Element>
void checkList(const std::vector<Element>& list, ElementKind kind, Diagnostics& diagnostics) {
  checkLength(list.size(), kind, diagnostics);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const ElementId id = list[i].id;
    if (isTooLong(id.id.text())) diagnostics.push_back(tooLong(id.id.text(), pointerTo(kind, i, "id"), {id}));
  }
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
    const auto each = [](const auto& list, ElementKind kind, const auto& check) {
      const JsonPointer document, all = document / listName(kind);
      for (std::size_t i = 0; i < list.size(); ++i) check(list[i], all / i);
    };
    each(mechanism.links, ElementKind::link, [this](const Link& link, const JsonPointer& at) {
      for (std::size_t k = 0; k < link.shapes.size(); ++k) {
        const LinkShape& shape = link.shapes[k];
        const JsonPointer shapes = at / "shapes", shapeAt = shapes / k;
        triple(link.id, shape.position, kCoordinate, shapeAt / "position");
        triple(link.id, shape.orientation, kNumber, shapeAt / "orientation");
        number(link.id, shape.scale, kNumber, shapeAt / "scale");
      }
      if (link.mass) mass(link.id, *link.mass, at);
    });
    each(mechanism.axes, ElementKind::axis, [this](const Axis& axis, const JsonPointer& at) {
      triple(axis.id, axis.point, kCoordinate, at / "point");
      triple(axis.id, axis.direction, kComponent, at / "direction");
      if (axis.direction) notTooShort(axis, at / "direction");
    });
    each(mechanism.turningJoints, ElementKind::turningJoint,
         [this](const TurningJoint& joint, const JsonPointer& at) {
           number(joint.id, joint.offset.value(), kLength, at / "offset");
         });
    each(mechanism.gearMeshes, ElementKind::gearMesh, [this](const GearMesh& mesh, const JsonPointer& at) {
      triple(mesh.id, mesh.pitchPoint, kCoordinate, at / "pitchPoint");
      number(mesh.id, mesh.faceWidth, kLength, at / "faceWidth");
    });
    each(mechanism.wheels, ElementKind::wheel, [this](const Wheel& wheel, const JsonPointer& at) {
      number(wheel.id, wheel.profileShift, kNumber, at / "profileShift");
      number(wheel.id, wheel.bore, kLength, at / "bore");
      number(wheel.id, wheel.backlash, kNumber, at / "backlash");
    });
    if (mechanism.gearDefaults) {
      number({}, mechanism.gearDefaults->pressureAngle, kNumber,
             JsonPointer() / "gearDefaults" / "pressureAngle");
      number({}, mechanism.gearDefaults->backlash, kNumber, JsonPointer() / "gearDefaults" / "backlash");
      number({}, mechanism.gearDefaults->faceWidth, kLength, JsonPointer() / "gearDefaults" / "faceWidth");
    }
    number({}, mechanism.driveTorque, kTorque, JsonPointer() / "driveTorque");
    number({}, mechanism.density, kDensity, JsonPointer() / "density");
    for (std::size_t i = 0; mechanism.gravity && i < mechanism.gravity->size(); ++i)
      number({}, (*mechanism.gravity)[i].value(), kComponent, JsonPointer() / "gravity" / i);
    each(mechanism.loads, ElementKind::load,
         [this](const Load& load, const JsonPointer& at) { action(load, at); });
    places(mechanism.view.nodes, JsonPointer() / "view" / "nodes");
    places(mechanism.view.ttNodes, JsonPointer() / "view" / "ttNodes");
    if (mechanism.view.camera) camera(*mechanism.view.camera);
  }

  Diagnostics found;

 private:
  static constexpr double kMax = static_cast<double>(kLargestLength);
  static constexpr const char* kCoordinate = toTranslate("expected a coordinate from -1e15 to 1e15.");
  static constexpr const char* kNumber = toTranslate("expected a number from -1e15 to 1e15.");
  static constexpr const char* kComponent = toTranslate("expected a component from -1e15 to 1e15.");
  static constexpr const char* kLength = toTranslate("expected a length from -1e15 to 1e15.");
  static constexpr const char* kDensity = toTranslate("expected a density from -1e15 to 1e15.");
  static constexpr const char* kMass = toTranslate("expected a mass from -1e15 to 1e15.");
  static constexpr const char* kMoment = toTranslate("expected a moment from -1e15 to 1e15.");
  static constexpr const char* kTorque = toTranslate("expected a torque from -1e15 to 1e15.");
  static constexpr const char* kForce = toTranslate("expected a force from -1e15 to 1e15.");

  static bool isWithin(double value) { return std::abs(value) <= kMax; }
  void number(const std::optional<ElementId>& element, double value, const char* what,
              const JsonPointer& pointer) {
    if (isWithin(value)) return;
    std::vector<ElementId> elements;
    if (element) elements.push_back(*element);
    found.push_back(makeDiagnostic(translated(what), pointer.text(), std::move(elements)));
  }
  void number(const std::optional<ElementId>& element, const std::optional<Number>& value, const char* what,
              const JsonPointer& pointer) {
    if (value) number(element, value->value(), what, pointer);
  }
  void triple(const ElementId& element, const std::optional<NumberTriple>& values, const char* what,
              const JsonPointer& pointer) {
    for (std::size_t i = 0; values && i < values->size(); ++i)
      number(element, (*values)[i].value(), what, pointer / i);
  }
  void mass(LinkId link, const LinkMass& mass, const JsonPointer& at) {
    number(link, mass.mass.value(), kMass, at / "mass");
    triple(link, mass.center, kCoordinate, at / "centerOfMass");
    for (std::size_t i = 0; mass.inertia && i < mass.inertia->size(); ++i)
      number(link, (*mass.inertia)[i].value(), kMoment, at / "inertia" / i);
  }
  void action(const Load& load, const JsonPointer& at) {
    if (const auto* inJoint = std::get_if<JointTorque>(&load.action)) {
      number(inJoint->joint, inJoint->torque.value(), kTorque, at / "torque");
    } else if (const auto* torque = std::get_if<LinkTorque>(&load.action)) {
      number(torque->link, torque->torque.value(), kTorque, at / "torque");
    } else {
      const auto& force = std::get<LinkForce>(load.action);
      triple(force.link, force.force, kForce, at / "force");
      triple(force.link, force.point, kCoordinate, at / "point");
    }
  }
  void places(const std::map<LinkId, SheetPoint>& nodes, const JsonPointer& pointer) {
    for (const auto& [link, place] : nodes) {
      if (isWithin(place.x) && isWithin(place.y)) continue;
      const std::string name = link.text();
      const JsonPointer at = pointer / name;
      number(link, place.x, kCoordinate, at / 0);
      number(link, place.y, kCoordinate, at / 1);
    }
  }
  void camera(const ViewCamera& camera) {
    for (std::size_t i = 0; i < camera.target.size(); ++i)
      number({}, camera.target[i], kCoordinate, JsonPointer() / "view" / "camera" / "target" / i);
    number({}, camera.distance, kLength, JsonPointer() / "view" / "camera" / "distance");
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
  if (isTooLong(mechanism.name)) diagnostics.push_back(tooLong(mechanism.name, "/name"));
  if (isTooLong(mechanism.unit)) diagnostics.push_back(tooLong(mechanism.unit, "/unit"));
  checkList(mechanism.links, ElementKind::link, diagnostics);
  checkList(mechanism.axes, ElementKind::axis, diagnostics);
  checkList(mechanism.turningJoints, ElementKind::turningJoint, diagnostics);
  checkList(mechanism.gearMeshes, ElementKind::gearMesh, diagnostics);
  checkList(mechanism.wheels, ElementKind::wheel, diagnostics);
  checkList(mechanism.couplings, ElementKind::coupling, diagnostics);
  checkLength(mechanism.states.size(), ElementKind::state, diagnostics);
  checkLength(mechanism.engaged.size(), "engaged", diagnostics);
  checkList(mechanism.loads, ElementKind::load, diagnostics);
  if (mechanism.balances) checkLength(mechanism.balances->size(), "balances", diagnostics);
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    const Link& link = mechanism.links[i];
    if (isTooLong(link.name))
      diagnostics.push_back(tooLong(link.name, pointerTo(ElementKind::link, i, "name"), {link.id}));
  }
  for (std::size_t i = 0; i < mechanism.states.size(); ++i) {
    const std::string& name = mechanism.states[i].name;
    if (isTooLong(name)) diagnostics.push_back(tooLong(name, pointerTo(ElementKind::state, i, "name")));
  }
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

}  // namespace geargraph::inline model
