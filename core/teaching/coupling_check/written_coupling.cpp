#include "core/teaching/coupling_check/written_coupling.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/foundations/files/json.h"

namespace geargraph {
namespace {

using Numbers = std::vector<CouplingNumber>;

Diagnostics wrongCoupling(std::string message, int line = 1) {
  Diagnostic diagnostic;
  diagnostic.code = Code::schema;
  diagnostic.message = std::move(message);
  diagnostic.line = line;
  diagnostic.column = 1;
  return {diagnostic};
}

Rational tenTo(int exponent) {
  return *Rational::fromText("1e" + std::to_string(exponent));
}

/// A matrix, or why it is none.
Expected<Numbers> squareOf(const std::vector<Numbers>& rows, const std::vector<int>& lines, int& size) {
  if (rows.empty()) return wrongCoupling(translated("There is no row of numbers."));
  if (rows.size() > static_cast<std::size_t>(kMaxWrittenRows))
    return wrongCoupling(translated("A matrix has at most %1 rows.", {std::to_string(kMaxWrittenRows)}));
  Numbers all;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != rows.size()) {
      return wrongCoupling(
          translated("Row %1 has %2 numbers; the matrix is square, with %3 rows.",
                     {std::to_string(i + 1), std::to_string(rows[i].size()), std::to_string(rows.size())}),
          lines[i]);
    }
    all.insert(all.end(), rows[i].begin(), rows[i].end());
  }
  if (size != 0 && size != static_cast<int>(rows.size()))
    return wrongCoupling(translated("The matrices and offsets are of different sizes."));
  size = static_cast<int>(rows.size());
  return all;
}

class CouplingReader {
 public:
  explicit CouplingReader(std::string_view text) : m_text(text) {}

  Expected<WrittenCoupling> readJson(std::optional<CouplingMatrix> alone) {
    auto parsed = JsonDocument::parse(m_text);
    if (!parsed) return parsed.error();
    const JsonValue root = parsed->root();
    if (root.is(JsonKind::array)) {
      if (!alone)
        return wrongCoupling(
            translated("Say which matrix this is: --matrix motor-to-joint or joint-to-motor."));
      if (auto error = readMatrix(root, *alone)) return *std::move(error);
      return std::move(m_written);
    }
    if (!root.is(JsonKind::object))
      return wrongCoupling(translated("An object or an array of rows is needed."));
    for (const auto& [name, which] : {std::pair("motorToJoint", CouplingMatrix::motorToJoint),
                                      std::pair("jointToMotor", CouplingMatrix::jointToMotor)}) {
      const auto member = root.member(name);
      if (!member) continue;
      if (auto error = readMatrix(*member, which)) return *std::move(error);
    }
    if (!m_written.motorToJoint && !m_written.jointToMotor)
      return wrongCoupling(translated("There is neither \"motorToJoint\" nor \"jointToMotor\"."));
    for (const auto& [name, into] : {std::pair("jointOffsets", &m_written.jointOffsets),
                                     std::pair("motorOffsets", &m_written.motorOffsets)}) {
      const auto member = root.member(name);
      if (!member) continue;
      auto row = rowOf(*member);
      if (!row) return row.error();
      if (static_cast<int>(row->size()) != m_written.size)
        return wrongCoupling(translated("The matrices and offsets are of different sizes."), lineOf(*member));
      *into = *std::move(row);
    }
    return std::move(m_written);
  }

  Expected<WrittenCoupling> readLines(CouplingMatrix which) {
    std::vector<Numbers> rows;
    std::vector<int> lines;
    int line = 0;
    for (std::size_t begin = 0; begin < m_text.size();) {
      const std::size_t end = std::min(m_text.find('\n', begin), m_text.size());
      std::string_view rest = m_text.substr(begin, end - begin);
      begin = end + 1;
      ++line;
      Numbers row;
      constexpr std::string_view kBetween = ",; \t\r[]";
      while (true) {
        const std::size_t first = rest.find_first_not_of(kBetween);
        if (first == std::string_view::npos) break;
        rest.remove_prefix(first);
        const std::string_view word = rest.substr(0, rest.find_first_of(kBetween));
        rest.remove_prefix(word.size());
        auto number = writtenNumber(word);
        if (!number)
          return wrongCoupling(translated("\"%1\" is no number.", {std::string(word.substr(0, 40))}), line);
        row.push_back(*std::move(number));
        if (row.size() > static_cast<std::size_t>(kMaxWrittenRows)) break;
      }
      if (row.empty()) continue;
      rows.push_back(std::move(row));
      lines.push_back(line);
    }
    auto matrix = squareOf(rows, lines, m_written.size);
    if (!matrix) return matrix.error();
    place(which) = *std::move(matrix);
    return std::move(m_written);
  }

 private:
  [[nodiscard]] std::optional<Numbers>& place(CouplingMatrix which) {
    return which == CouplingMatrix::motorToJoint ? m_written.motorToJoint : m_written.jointToMotor;
  }

  [[nodiscard]] int lineOf(const JsonValue& value) const {
    return 1 + static_cast<int>(std::count(
                   m_text.begin(), m_text.begin() + static_cast<std::ptrdiff_t>(value.offset()), '\n'));
  }

  [[nodiscard]] Expected<Numbers> rowOf(const JsonValue& value) const {
    if (!value.is(JsonKind::array))
      return wrongCoupling(translated("A row is an array of numbers."), lineOf(value));
    Numbers row;
    std::optional<Diagnostics> error;
    value.forEachElement([&](const JsonValue& each, std::size_t /*position*/) {
      if (error) return;
      const std::string text = each.is(JsonKind::string) ? each.string() : std::string(each.slice());
      const bool isNumber = each.is(JsonKind::string) || each.is(JsonKind::number);
      auto number = isNumber ? writtenNumber(text) : std::nullopt;
      if (!number) {
        error = wrongCoupling(translated("\"%1\" is no number.", {text.substr(0, 40)}), lineOf(each));
      } else {
        row.push_back(*std::move(number));
      }
    });
    if (error) return *std::move(error);
    return row;
  }

  [[nodiscard]] std::optional<Diagnostics> readMatrix(const JsonValue& value, CouplingMatrix which) {
    if (!value.is(JsonKind::array))
      return wrongCoupling(translated("A matrix is an array of rows."), lineOf(value));
    std::vector<Numbers> rows;
    std::vector<int> lines;
    std::optional<Diagnostics> error;
    value.forEachElement([&](const JsonValue& each, std::size_t /*position*/) {
      if (error) return;
      auto row = rowOf(each);
      if (!row) {
        error = row.error();
        return;
      }
      rows.push_back(*std::move(row));
      lines.push_back(lineOf(each));
    });
    if (error) return error;
    auto matrix = squareOf(rows, lines, m_written.size);
    if (!matrix) return matrix.error();
    place(which) = *std::move(matrix);
    return std::nullopt;
  }

  std::string_view m_text;
  WrittenCoupling m_written;
};

bool looksLikeJson(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return false;
  if (text[first] == '{') return true;
  // "[[1, 2], ..." is JSON; "[1 2]" of another program's output is lines.
  if (text[first] != '[') return false;
  const std::size_t second = text.find_first_not_of(" \t\r\n", first + 1);
  return second != std::string_view::npos && text[second] == '[' && text.find(',') != std::string_view::npos;
}

}  // namespace

std::optional<CouplingNumber> writtenNumber(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto value = Rational::fromText(text);
  if (!value) return std::nullopt;
  CouplingNumber number{*value, 0, std::string(text)};
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos) return number;
  const std::size_t exponent = text.find_first_of("eE");
  const auto digits = static_cast<int>(std::min(exponent, text.size()) - point) - 1;
  int power = 0;
  if (exponent != std::string_view::npos) {
    const auto read = Rational::fromText(text.substr(exponent + (text[exponent + 1] == '+' ? 2 : 1)));
    if (!read || !read->isInteger()) return std::nullopt;
    power = static_cast<int>(read->toDouble());
  }
  const Rational half(1, 2);
  number.tolerance = std::max(half * tenTo(power - digits), value->abs() * tenTo(-15));
  return number;
}

bool isWrittenCoupling(std::string_view text) {
  if (!looksLikeJson(text)) return false;
  const auto parsed = JsonDocument::parse(text);
  if (!parsed || !parsed->root().is(JsonKind::object)) return false;
  return parsed->root().member("motorToJoint") || parsed->root().member("jointToMotor");
}

Expected<WrittenCoupling> readWrittenCoupling(std::string_view text, std::optional<CouplingMatrix> alone) {
  CouplingReader reader(text);
  if (looksLikeJson(text) || !alone) return reader.readJson(alone);
  return reader.readLines(*alone);
}

}  // namespace geargraph
