#pragma once

#include "core/mechanism/model/patch_parts.h"

namespace geargraph {

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
  template <class Value>
  requires(std::is_arithmetic_v<Value> || std::is_enum_v<Value>) void one(Value /*value*/) {}
  void one(const CanvasPoint& /*place*/) {}
  void one(const JointLimits& limits) { add(limits.low, limits.high); }
  void one(const LinkMass& mass) { add(mass.mass, mass.center, mass.inertia); }
  template <class Value>
  void one(const SharedOptional<Value>& value) {
    if (!value) return;
    block(sizeof(Value));
    one(*value);
  }
  void one(const JointTorque& action) { add(action.torque); }
  void one(const LinkTorque& action) { add(action.torque); }
  void one(const LinkForce& action) { add(action.force, action.point); }
  void one(const HoldingTorque::OnLink& /*place*/) {}
  template <class... Values>
  void one(const std::variant<Values...>& value) {
    std::visit([this](const auto& held) { one(held); }, value);
  }
  template <class Object>
  requires Described<Object>
  void one(const Object& object) {
    forEachField<Object>([&](const auto& field) { one(object.*field.member); });
    one(object.unknown);
  }
  void one(const TextPatch& patch) { add(patch.before, patch.after); }
  template <class Element>
  void one(const ListRun<Element>& run) {
    add(run.before, run.after);
  }
  template <class Element>
  void one(const StatedListPatch<Element>& patch) {
    add(patch.list);
  }
  void one(const MemberPatch& patch) { add(patch.changed, patch.replaced); }
  template <class Value>
  void one(const MapPatch<Value>& patch) {
    add(patch.before, patch.after);
  }
  template <class Object>
  void one(const ObjectPatch<Object>& patch) {
    std::apply([this](const auto&... fields) { add(fields...); }, patch.fields);
    add(patch.members);
  }

  std::size_t m_total = 0;
};

}  // namespace geargraph
