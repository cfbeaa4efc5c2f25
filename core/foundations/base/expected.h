#pragma once

#include <utility>
#include <variant>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/diagnostic.h"

namespace geargraph {

/// A value, or the diagnostics that explain why there is none. The member names are those of std::expected,
/// which this toolchain lacks, so that this can become an alias later.
///
/// A failure has at least one diagnostic, one of which is an error.
template <class Value>
class [[nodiscard]] Expected {
 public:
  Expected(Value value)
      : m_state(std::in_place_index<0>, std::move(value)) {}  // NOLINT(google-explicit-constructor)
  Expected(Diagnostic why) : m_state(std::in_place_index<1>, Diagnostics{std::move(why)}) {}  // NOLINT
  Expected(Diagnostics why) : m_state(std::in_place_index<1>, std::move(why)) {               // NOLINT
    GEARGRAPH_REQUIRE(!std::get<1>(m_state).empty());
  }

  [[nodiscard]] bool has_value() const { return m_state.index() == 0; }
  explicit operator bool() const { return has_value(); }

  [[nodiscard]] const Value& value() const& {
    GEARGRAPH_REQUIRE(has_value());
    return std::get<0>(m_state);
  }
  [[nodiscard]] Value&& value() && {
    GEARGRAPH_REQUIRE(has_value());
    return std::get<0>(std::move(m_state));
  }
  [[nodiscard]] const Value& operator*() const& { return value(); }
  [[nodiscard]] Value&& operator*() && { return std::move(*this).value(); }
  [[nodiscard]] const Value* operator->() const { return &value(); }

  [[nodiscard]] const Diagnostics& error() const {
    GEARGRAPH_REQUIRE(!has_value());
    return std::get<1>(m_state);
  }

 private:
  std::variant<Value, Diagnostics> m_state;
};

}  // namespace geargraph
