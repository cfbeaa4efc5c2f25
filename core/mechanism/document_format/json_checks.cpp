#include "core/mechanism/document_format/json_checks.h"

#include <algorithm>
#include <charconv>
#include <numeric>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/decimal.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

/// The decimal exponent of the leading digit of a JSON number: 2 for 345.6, -1 for 0.12. Zero gives 0.
long magnitude(std::string_view number) {
  if (number.front() == '-') number.remove_prefix(1);
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  const std::string_view mantissa = number.substr(0, e);
  const auto point = static_cast<long>(std::min(mantissa.find('.'), mantissa.size()));
  const std::size_t leading = mantissa.find_first_not_of("0.");
  if (leading == std::string_view::npos) return 0;
  const long place = static_cast<long>(leading) < point ? point - static_cast<long>(leading) - 1
                                                        : point - static_cast<long>(leading);
  long exponent = 0;
  if (e < number.size()) {
    std::string_view written = number.substr(e + 1);
    if (written.front() == '+') written.remove_prefix(1);
    const auto [end, error] = std::from_chars(written.data(), written.data() + written.size(), exponent);
    if (error != std::errc{}) exponent = written.front() == '-' ? -1'000'000'000 : 1'000'000'000;
  }
  return place + exponent;
}

bool isTooLarge(std::string_view number) {
  return !decimalFrom(number) && magnitude(number) > 0;
}

/// Walks all values and keeps the way to the one at hand.
class Walk {
 public:
  explicit Walk(JsonDiagnostics& diagnostics) : m_diagnostics(diagnostics) {}

  void visit(JsonValue value) {
    switch (value.kind()) {
      case JsonKind::array:
        return array(value);
      case JsonKind::object:
        return object(value);
      case JsonKind::number:
        if (isTooLarge(value.slice()))
          add(translated("The number is too large; its double would be infinite."), value);
        return;
      case JsonKind::null:
      case JsonKind::boolean:
      case JsonKind::string:
        return;
    }
  }

 private:
  struct Step {
    std::optional<JsonValue> key;  ///< of a member; none for an element
    std::size_t position = 0;
  };

  void add(std::string message, JsonValue at) {
    std::string pointer;
    for (const Step& step : m_way)
      pointer += step.key ? pointerStep(step.key->string()) : pointerStep(step.position);
    m_diagnostics.add(Code::schema, std::move(message), {}, std::move(pointer), at);
  }

  void array(JsonValue value) {
    const std::size_t size = value.size();
    if (size > kMaxListLength) {
      add(translated("A list has at most 100,000 elements; this one has %1.", {std::to_string(size)}), value);
      return;
    }
    value.forEachElement([&](JsonValue element, std::size_t position) {
      m_way.push_back({std::nullopt, position});
      visit(element);
      m_way.pop_back();
    });
  }

  void object(JsonValue value) {
    std::vector<JsonValue> keys;
    std::unordered_set<std::string> names;  // only for large objects; small ones are compared pair by pair
    constexpr std::size_t kSmall = 16;
    value.forEachMember([&](JsonValue key, JsonValue member) {
      m_way.push_back({key, 0});
      bool twice = false;
      if (keys.size() < kSmall) {
        const std::string name = key.string();
        twice = std::any_of(keys.begin(), keys.end(), [&](JsonValue other) { return other.equals(name); });
        keys.push_back(key);
      } else {
        if (names.empty()) {
          for (const JsonValue other : keys) names.insert(other.string());
        }
        twice = !names.insert(key.string()).second;
      }
      if (twice) add(translated("The member occurs twice in its object; only one may stay."), key);
      visit(member);
      m_way.pop_back();
    });
  }

  JsonDiagnostics& m_diagnostics;
  std::vector<Step> m_way;
};

/// Moves (line, column) from one offset of the text to a later one.
struct Place {
  std::size_t offset = 0;
  int line = 1;
  int column = 1;

  void advanceTo(std::size_t target, std::string_view text) {
    for (; offset < target; ++offset) {
      const bool continues = (static_cast<unsigned char>(text[offset]) & 0xC0U) == 0x80U;
      if (text[offset] == '\n') {
        ++line;
        column = 1;
      } else if (!continues) {
        ++column;
      }
    }
  }
};

}  // namespace

void JsonDiagnostics::add(Code code, std::string message, std::vector<ElementId> elements,
                          std::string pointer, JsonValue at) {
  m_pointers.insert(pointer);
  m_diagnostics.push_back(
      {{code, std::move(message), std::move(elements), std::move(pointer), 0, 0}, at.offset()});
}

bool JsonDiagnostics::covers(std::string_view pointer) const {
  while (true) {
    if (m_pointers.contains(std::string(pointer))) return true;
    if (pointer.empty()) return false;
    pointer = pointer.substr(0, pointer.rfind('/'));
  }
}

Diagnostics JsonDiagnostics::inOrder() const {
  std::vector<std::size_t> order(m_diagnostics.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return m_diagnostics[a].offset < m_diagnostics[b].offset;
  });
  Diagnostics result;
  result.reserve(order.size());
  Place place;
  for (const std::size_t i : order) {
    place.advanceTo(m_diagnostics[i].offset, m_document.text());
    Diagnostic& diagnostic = result.emplace_back(m_diagnostics[i].diagnostic);
    diagnostic.line = place.line;
    diagnostic.column = place.column;
    if (diagnostic.code == Code::schema) {
      diagnostic.message =
          (diagnostic.pointer.empty() ? "/" : diagnostic.pointer) + ": " + diagnostic.message;
    }
  }
  return result;
}

void checkJson(const JsonDocument& document, JsonDiagnostics& diagnostics) {
  Walk(diagnostics).visit(document.root());
}

std::string pointerStep(std::string_view name) {
  std::string step = "/";
  for (const char c : name) {
    if (c == '~') {
      step += "~0";
    } else if (c == '/') {
      step += "~1";
    } else {
      step += c;
    }
  }
  return step;
}

std::string pointerStep(std::size_t position) {
  return "/" + std::to_string(position);
}

}  // namespace geargraph
