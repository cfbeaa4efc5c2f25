#include "core/teaching/derivation/result_table.h"

#include <array>
#include <charconv>

#include "core/foundations/base/locale.h"
#include "core/foundations/base/readable.h"
#include "core/teaching/derivation/named_results.h"

namespace geargraph {

std::vector<ResultValue> ResultTable::values(int row) const {
  std::vector<ResultValue> values;
  for (const ResultEntry& entry : this->row(row)) values.push_back({entry.column, entry.value});
  return values;
}

std::set<ElementId> ResultTable::elementsOfRow(int row) const {
  const ElementId element = rowHeading(row).element;
  return element.id.empty() ? std::set<ElementId>() : std::set<ElementId>{element};
}

std::set<ElementId> ResultTable::elementsOfCell(int row, int column) const {
  std::set<ElementId> elements = elementsOfRow(row);
  if (headsAreRates()) elements.insert(columnHeading(column).element);
  return elements;
}

CellExplanation ResultTable::explanation(int row, int column) const {
  const auto shown = entry(row, column);
  return {rowHeading(row).text + ", " + columnHeading(column).text + ": " + (shown ? shown->text : "0"),
          definitionOf(m_result)};
}

std::optional<ResultEntry> ResultTable::entry(int row, int column) const {
  for (ResultEntry& entry : this->row(row)) {
    if (entry.column == column) return std::move(entry);
  }
  return std::nullopt;
}

std::string latexOf(const Rational& value) {
  const std::string text = value.toString();
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return text;
  const bool negative = text.front() == '-';
  return (negative ? "-\\frac{" : "\\frac{") + text.substr(negative ? 1 : 0, slash - (negative ? 1 : 0)) +
         "}{" + text.substr(slash + 1) + "}";
}

std::string readableLatex(const Rational& value) {
  return isLongFraction(value.toString()) ? spokenTexNumber(shortDecimal(value.toDouble())) : latexOf(value);
}

std::string readableLatex(const ResultEntry& entry) {
  const bool isLong = !entry.isFormula && isLongFraction(entry.text);
  return isLong ? spokenTexNumber(shortDecimal(entry.value)) : entry.latex;
}

std::string shortDecimal(double value) {
  std::array<char, 32> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value + 0.0, std::chars_format::general, 6);
  return {digits.data(), end.ptr};
}

ResultEntry decimalEntry(int column, double value) {
  const std::string text = shortDecimal(value);
  return {column, text, spokenTexNumber(text), value, false};
}

ResultEntry fractionEntry(int column, const Rational& value) {
  return {column, value.toString(), latexOf(value), value.toDouble(), false};
}

ResultEntry irrationalEntry(int column, double value) {
  const std::string text = shortDecimal(value);
  return {column, "≈ " + text, "\\approx " + spokenTexNumber(text), value, false};
}

}  // namespace geargraph
