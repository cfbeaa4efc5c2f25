#include "core/foundations/files/json_writer.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/foundations/base/contract.h"
#include "core/foundations/files/json.h"

namespace geargraph {

void JsonWriter::begin(char bracket, Layout layout) {
  beforeElement();
  m_out.put(bracket);
  const bool inRow = !m_open.empty() && m_open.back().layout == Layout::row;
  m_open.push_back({inRow ? Layout::row : layout, true});
}

void JsonWriter::end(char bracket) {
  GEARGRAPH_REQUIRE(!m_open.empty() && !m_afterKey);
  const Container container = m_open.back();
  m_open.pop_back();
  if (container.layout == Layout::lines && !container.isEmpty) newLine();
  m_out.put(bracket);
  if (m_open.empty()) m_out.put('\n');
}

void JsonWriter::newLine() {
  m_out.put('\n');
  for (std::size_t i = 0; i < m_open.size(); ++i) m_out.write("  ");
}

void JsonWriter::beforeElement() {
  if (m_afterKey || m_open.empty()) {
    m_afterKey = false;
    return;
  }
  Container& container = m_open.back();
  const bool isRow = container.layout == Layout::row;
  if (!container.isEmpty) m_out.write(isRow ? ", " : ",");
  container.isEmpty = false;
  if (!isRow) newLine();
}

void JsonWriter::key(std::string_view name) {
  string(name);
  m_out.write(": ");
  m_afterKey = true;
}

void JsonWriter::string(std::string_view text) {
  std::string quoted;
  appendJsonString(quoted, text);
  json(quoted);
}

void JsonWriter::number(std::int64_t value) {
  std::array<char, 24> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  GEARGRAPH_REQUIRE(error == std::errc{});
  json(std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())));
}

void JsonWriter::number(double value) {
  GEARGRAPH_REQUIRE(std::isfinite(value));
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value + 0.0);
  GEARGRAPH_REQUIRE(error == std::errc{});
  json(std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())));
}

void JsonWriter::numberOrNull(double value) {
  std::isfinite(value) ? number(value) : null();
}

void JsonWriter::json(std::string_view text) {
  beforeElement();
  m_out.write(text);
}

}  // namespace geargraph
