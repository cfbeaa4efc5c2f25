#pragma once

#include <memory>
#include <utility>

namespace geargraph {

/// An optional value for a member that few of many objects have: it takes two pointers in the object, and
/// copies of the object share the value. Equality compares the values.
template <class Value>
class SharedOptional {
 public:
  SharedOptional() = default;
  SharedOptional(Value value)  // NOLINT(google-explicit-constructor)
      : m_value(std::make_shared<const Value>(std::move(value))) {}

  [[nodiscard]] explicit operator bool() const { return m_value != nullptr; }
  [[nodiscard]] const Value& operator*() const { return *m_value; }
  [[nodiscard]] const Value* operator->() const { return m_value.get(); }

  friend bool operator==(const SharedOptional& a, const SharedOptional& b) {
    return a.m_value == b.m_value || (a.m_value && b.m_value && *a.m_value == *b.m_value);
  }

 private:
  std::shared_ptr<const Value> m_value;
};

}  // namespace geargraph
