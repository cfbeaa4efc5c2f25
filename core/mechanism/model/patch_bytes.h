#pragma once

#include "core/mechanism/model/patch.h"

namespace geargraph::inline model {

/// Sums the heap memory that values own.
class ByteCount {
 public:
  template <class... Values>
  void add(const Values&... values) {
    (one(values), ...);
  }
  [[nodiscard]] std::size_t total() const { return m_total; }

 private:
  /// The overhead of an allocation.
  static constexpr std::size_t kAllocation = 16;

  void block(std::size_t size) { m_total += size == 0 ? 0 : size + kAllocation; }

  void one(const std::string& text) {
    constexpr std::size_t kInside = 15;  // kept within the object
    block(text.capacity() > kInside ? text.capacity() + 1 : 0);
  }
  /// A Number that is only a double owns nothing; any other owns its text and its fraction.
  void one(const Number& number) {
    if (number == Number::fromDouble(number.value())) return;
    constexpr std::size_t kWritten = 64;
    m_total += kWritten + 2 * number.text().size() + 2 * kAllocation;
  }
  template <class Value>
  void one(const std::optional<Value>& value) {
    if (value) one(*value);
  }
  template <class Value, std::size_t count>
  void one(const std::array<Value, count>& values) {
    for (const Value& each : values) one(each);
  }
  template <class First, class Second>
  void one(const std::pair<First, Second>& pair) {
    add(pair.first, pair.second);
  }
  template <class Value>
  void one(const std::vector<Value>& values) {
    block(values.capacity() * sizeof(Value));
    for (const Value& each : values) one(each);
  }
  template <class Tag>
  void one(const Id<Tag>& /*id*/) {}
  void one(std::size_t /*number*/) {}
  void one(LoadSharing /*sharing*/) {}
  void one(const SheetPoint& /*place*/) {}
  void one(const SheetNote& note) { add(note.text, note.unknown); }
  void one(const LinkShape& shape) {
    add(shape.file, shape.position, shape.orientation, shape.scale, shape.unknown);
  }
  void one(const ViewCamera& camera) { add(camera.unknown); }
  void one(const LinkMass& mass) { add(mass.mass, mass.center, mass.inertia); }
  template <class Value>
  void one(const SharedOptional<Value>& value) {
    if (!value) return;
    block(sizeof(Value));
    one(*value);
  }
  void one(const Link& link) { add(link.name, link.shapes, link.mass, link.unknown); }
  void one(const Axis& axis) { add(axis.point, axis.direction, axis.unknown); }
  void one(const TurningJoint& joint) {
    add(joint.offset, joint.limits.low, joint.limits.high, joint.unknown);
  }
  void one(const GearMesh& mesh) {
    add(mesh.pitchPoint, mesh.faceWidth, mesh.efficiency, mesh.friction, mesh.unknown);
  }
  void one(const Wheel& wheel) { add(wheel.profileShift, wheel.bore, wheel.backlash, wheel.unknown); }
  void one(const GearDefaults& all) {
    add(all.pressureAngle, all.backlash, all.faceWidth, all.efficiency, all.friction, all.unknown);
  }
  void one(const Input& input) { add(input.speed, input.unknown); }
  void one(const Coupling& coupling) { add(coupling.links, coupling.unknown); }
  void one(const ShiftState& state) { add(state.name, state.engaged, state.unknown); }
  void one(const JointTorque& action) { add(action.torque); }
  void one(const LinkTorque& action) { add(action.torque); }
  void one(const LinkForce& action) { add(action.force, action.point); }
  void one(const Load& load) {
    std::visit([this](const auto& action) { one(action); }, load.action);
    add(load.unknown);
  }
  void one(const Balance& balance) { add(balance.unknown); }
  void one(const TextPatch& patch) { add(patch.before, patch.after); }
  template <class Element>
  void one(const ListRun<Element>& run) {
    add(run.before, run.after);
  }
  void one(const MemberPatch& patch) { add(patch.changed, patch.replaced); }

  std::size_t m_total = 0;
};

}  // namespace geargraph::inline model
