#include "core/teaching/coupling_check/coupling_check.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/json_writer.h"

namespace geargraph {
namespace {

using Written = std::vector<CouplingNumber>;
using Exact = std::vector<Rational>;
using Order = std::vector<int>;

constexpr int kMaxPermuted = 4;
constexpr std::size_t kMaxEntries = 12;

std::string titleOfMatrix(CouplingMatrix which) {
  return which == CouplingMatrix::motorToJoint ? translated("motors to joints")
                                               : translated("joints to motors");
}

/// One written matrix against that of the train.
class MatrixCheck {
 public:
  MatrixCheck(const Mechanism& mechanism, const JointCoupling& coupling, CouplingMatrix which,
              const Written& written)
      : m_mechanism(mechanism),
        m_coupling(coupling),
        m_which(which),
        m_written(written),
        m_size(coupling.size()),
        m_expected(which == CouplingMatrix::motorToJoint ? coupling.motorToJoint : coupling.jointToMotor),
        m_other(which == CouplingMatrix::motorToJoint ? coupling.jointToMotor : coupling.motorToJoint) {}

  std::vector<CouplingFinding> find() {
    Order same(static_cast<std::size_t>(m_size));
    std::iota(same.begin(), same.end(), 0);
    if (agrees(m_expected)) return {finding("right", translated("right"), false)};
    if (agrees(transposed(m_expected)))
      return {finding("transposed", translated("rows and columns are exchanged: this is the transpose."))};
    if (agrees(m_other)) {
      return {finding("other-matrix", translated("this is the matrix from %1: the inverse.",
                                                 {titleOfMatrix(m_which == CouplingMatrix::motorToJoint
                                                                    ? CouplingMatrix::jointToMotor
                                                                    : CouplingMatrix::motorToJoint)}))};
    }
    if (agrees(transposed(m_other)))
      return {finding("torque-matrix", translated("this is the matrix of torques, the transposed inverse."))};
    if (const auto signs = turnedOver(same, same)) return {finding("sign", signSentence(*signs))};
    if (auto order = findOrder(same)) return {finding("order", *std::move(order))};
    if (const auto factors = factorSentence(true)) return {finding("factor", *factors)};
    if (const auto factors = factorSentence(false)) return {finding("factor", *factors)};
    return entries();
  }

 private:
  [[nodiscard]] const CouplingNumber& at(int row, int column) const {
    return m_written[static_cast<std::size_t>(row * m_size + column)];
  }
  [[nodiscard]] const Rational& expected(int row, int column) const {
    return m_expected[static_cast<std::size_t>(row * m_size + column)];
  }
  [[nodiscard]] Exact transposed(const Exact& matrix) const {
    Exact result(matrix.size());
    for (int row = 0; row < m_size; ++row) {
      for (int column = 0; column < m_size; ++column)
        result[static_cast<std::size_t>(column * m_size + row)] =
            matrix[static_cast<std::size_t>(row * m_size + column)];
    }
    return result;
  }
  [[nodiscard]] bool agrees(const Exact& matrix) const {
    return std::equal(
        m_written.begin(), m_written.end(), matrix.begin(),
        [](const CouplingNumber& written, const Rational& exact) { return written.standsFor(exact); });
  }

  [[nodiscard]] CouplingFinding finding(std::string_view name, const std::string& what,
                                        bool isError = true) const {
    return {name, translated("Matrix from %1: %2", {titleOfMatrix(m_which), what}), isError};
  }

  [[nodiscard]] bool rowsAreJoints() const { return m_which == CouplingMatrix::motorToJoint; }
  [[nodiscard]] int labelOfRow(int row) const {
    const auto& joints = rowsAreJoints() ? m_coupling.joints : m_coupling.motors;
    return m_mechanism.jointLabel(joints[static_cast<std::size_t>(row)]);
  }
  [[nodiscard]] int labelOfColumn(int column) const {
    const auto& joints = rowsAreJoints() ? m_coupling.motors : m_coupling.joints;
    return m_mechanism.jointLabel(joints[static_cast<std::size_t>(column)]);
  }
  [[nodiscard]] std::string rowWord(int row) const {
    const std::string label = std::to_string(labelOfRow(row));
    return rowsAreJoints() ? translated("joint %1", {label}) : translated("motor %1", {label});
  }
  [[nodiscard]] std::string columnWord(int column) const {
    const std::string label = std::to_string(labelOfColumn(column));
    return rowsAreJoints() ? translated("motor %1", {label}) : translated("joint %1", {label});
  }

  /// Rows and columns whose signs are the other way.
  struct Signs {
    std::vector<int> rows;
    std::vector<int> columns;
  };

  /// The signs of rows and columns with which the written entries are those expected at these places; the
  /// fewest in each connected part. std::nullopt if there are none.
  [[nodiscard]] std::optional<Signs> turnedOver(const Order& rows, const Order& columns) const {
    std::vector<int> sign(static_cast<std::size_t>(2 * m_size), 0);  // rows, then columns; 0: not known yet
    Signs signs;
    for (int start = 0; start < 2 * m_size; ++start) {
      if (sign[static_cast<std::size_t>(start)] != 0) continue;
      std::vector<int> part{start};
      sign[static_cast<std::size_t>(start)] = 1;
      for (std::size_t next = 0; next < part.size(); ++next) {
        for (int other = 0; other < m_size; ++other) {
          const bool isRow = part[next] < m_size;
          const int row = isRow ? part[next] : other;
          const int column = isRow ? other : part[next] - m_size;
          const CouplingNumber& written = at(row, column);
          const Rational& exact =
              expected(rows[static_cast<std::size_t>(row)], columns[static_cast<std::size_t>(column)]);
          if (exact.isZero()) {
            if (!written.standsFor(0)) return std::nullopt;
            continue;
          }
          const bool isSame = written.standsFor(exact);
          if (!isSame && !written.standsFor(-exact)) return std::nullopt;
          const int wanted = (isSame ? 1 : -1) * sign[static_cast<std::size_t>(part[next])];
          int& known = sign[static_cast<std::size_t>(isRow ? column + m_size : row)];
          if (known == 0) {
            known = wanted;
            part.push_back(isRow ? column + m_size : row);
          } else if (known != wanted) {
            return std::nullopt;
          }
        }
      }
      const auto turned = std::count_if(part.begin(), part.end(),
                                        [&](int each) { return sign[static_cast<std::size_t>(each)] < 0; });
      const int against = 2 * turned > static_cast<std::ptrdiff_t>(part.size()) ? 1 : -1;
      for (const int each : part) {
        if (sign[static_cast<std::size_t>(each)] != against) continue;
        each < m_size ? signs.rows.push_back(each) : signs.columns.push_back(each - m_size);
      }
    }
    return signs;
  }

  [[nodiscard]] std::string signSentence(const Signs& signs) const {
    std::vector<std::string> names;
    for (const int row : signs.rows) names.push_back(rowWord(row));
    for (const int column : signs.columns) names.push_back(columnWord(column));
    return translated("all would be right if these turned the other way: %1.", {listed(names, 8)});
  }

  /// Joints or motors in another order, perhaps with other directions.
  [[nodiscard]] std::optional<std::string> findOrder(const Order& same) const {
    if (m_size > kMaxPermuted) return std::nullopt;
    Order rows = same;
    do {
      Order columns = same;
      do {
        if (rows == same && columns == same) continue;
        const auto signs = turnedOver(rows, columns);
        if (!signs) continue;
        std::vector<std::string> rowNames;
        std::vector<std::string> columnNames;
        for (const int row : rows) rowNames.push_back(rowWord(row));
        for (const int column : columns) columnNames.push_back(columnWord(column));
        std::string text = translated("all would be right with rows for %1 and columns for %2.",
                                      {listed(rowNames, 8), listed(columnNames, 8)});
        if (!signs->rows.empty() || !signs->columns.empty())
          text += ' ' + translated("Directions differ, too.");
        return text;
      } while (std::next_permutation(columns.begin(), columns.end()));
    } while (std::next_permutation(rows.begin(), rows.end()));
    return std::nullopt;
  }

  /// Rows (or columns) that are the expected ones times a number each.
  [[nodiscard]] std::optional<std::string> factorSentence(bool ofRows) const {
    std::vector<std::string> parts;
    for (int line = 0; line < m_size; ++line) {
      std::optional<Rational> factor;
      for (int k = 0; k < m_size; ++k) {
        const CouplingNumber& written = ofRows ? at(line, k) : at(k, line);
        const Rational& exact = ofRows ? expected(line, k) : expected(k, line);
        if (exact.isZero()) {
          if (!written.standsFor(0)) return std::nullopt;
          continue;
        }
        if (!factor) factor = written.value / exact;
        if (!written.standsFor(*factor * exact)) return std::nullopt;
      }
      if (!factor || factor->isZero()) return std::nullopt;
      if (*factor == Rational(1)) continue;
      parts.push_back(
          translated("%1 by %2", {ofRows ? rowWord(line) : columnWord(line), factor->toString()}));
    }
    if (parts.empty()) return std::nullopt;
    return translated("all is right but for factors: %1.", {listed(parts, 8)});
  }

  [[nodiscard]] std::vector<CouplingFinding> entries() const {
    std::vector<CouplingFinding> found;
    for (int row = 0; row < m_size; ++row) {
      for (int column = 0; column < m_size; ++column) {
        const CouplingNumber& written = at(row, column);
        const Rational& exact = expected(row, column);
        if (written.standsFor(exact) || found.size() >= kMaxEntries) continue;
        const bool isSign = !exact.isZero() && written.standsFor(-exact);
        found.push_back(finding(
            "entry", isSign ? translated("%1, %2: the sign of %3 is wrong; it is %4.",
                                         {rowWord(row), columnWord(column), written.text, exact.toString()})
                            : translated("%1, %2: %3 should be %4.", {rowWord(row), columnWord(column),
                                                                      written.text, exact.toString()})));
      }
    }
    return found;
  }

  const Mechanism& m_mechanism;
  const JointCoupling& m_coupling;
  CouplingMatrix m_which;
  const Written& m_written;
  int m_size;
  const Exact& m_expected;
  const Exact& m_other;
};

/// The product of what is written, with a bound for how far rounding may carry it.
struct Product {
  Rational value;
  Rational bound;
};
Product rowTimesColumn(const Written& a, std::size_t row, const Written& b, std::size_t column,
                       std::size_t columns, std::size_t size) {
  Product sum;
  for (std::size_t k = 0; k < size; ++k) {
    const CouplingNumber& x = a[row * size + k];
    const CouplingNumber& y = b[k * columns + column];
    sum.value += x.value * y.value;
    sum.bound += x.value.abs() * y.tolerance + y.value.abs() * x.tolerance + x.tolerance * y.tolerance;
  }
  return sum;
}

std::optional<CouplingFinding> checkInverse(const WrittenCoupling& written) {
  if (!written.motorToJoint || !written.jointToMotor) return std::nullopt;
  const auto size = static_cast<std::size_t>(written.size);
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) {
      const Product product =
          rowTimesColumn(*written.motorToJoint, row, *written.jointToMotor, column, size, size);
      const Rational unit = row == column ? 1 : 0;
      if ((product.value - unit).abs() <= product.bound) continue;
      return CouplingFinding{
          "not-inverse",
          translated("The two matrices are not inverse of each other: their product has %1 in row %2, column "
                     "%3, not %4.",
                     {product.value.toString(), std::to_string(row + 1), std::to_string(column + 1),
                      unit.toString()})};
    }
  }
  return std::nullopt;
}

std::optional<CouplingFinding> checkOffsets(const WrittenCoupling& written) {
  if (!written.jointOffsets || !written.motorOffsets || !written.jointToMotor) return std::nullopt;
  const auto size = static_cast<std::size_t>(written.size);
  for (std::size_t row = 0; row < size; ++row) {
    const Product back = rowTimesColumn(*written.jointToMotor, row, *written.jointOffsets, 0, 1, size);
    const CouplingNumber& offset = (*written.motorOffsets)[row];
    if ((offset.value + back.value).abs() <= back.bound + offset.tolerance) continue;
    return CouplingFinding{
        "offsets", translated("The offsets do not cancel: motor offset %1 is %2, the joints' offsets ask "
                              "for %3.",
                              {std::to_string(row + 1), offset.text, (-back.value).toString()})};
  }
  return std::nullopt;
}

}  // namespace

std::vector<CouplingFinding> checkWrittenCoupling(const Mechanism& mechanism, const JointCoupling& coupling,
                                                  const WrittenCoupling& written) {
  std::vector<CouplingFinding> findings;
  for (const CouplingMatrix which : {CouplingMatrix::motorToJoint, CouplingMatrix::jointToMotor}) {
    if (!written.of(which)) continue;
    auto found = MatrixCheck(mechanism, coupling, which, *written.of(which)).find();
    std::move(found.begin(), found.end(), std::back_inserter(findings));
  }
  if (auto mismatch = checkInverse(written)) findings.push_back(*std::move(mismatch));
  if (auto mismatch = checkOffsets(written)) findings.push_back(*std::move(mismatch));
  return findings;
}

std::string couplingCheckJson(const Mechanism& mechanism, const JointCoupling& coupling,
                              const std::vector<CouplingFinding>& findings) {
  TextSink sink;
  {
    JsonWriter json(sink);
    const auto labels = [&](std::string_view name, const std::vector<JointOrdinal>& joints) {
      json.key(name);
      json.beginArray(JsonWriter::Layout::row);
      for (const JointOrdinal joint : joints)
        json.number(static_cast<std::int64_t>(mechanism.jointLabel(joint)));
      json.endArray();
    };
    json.beginObject();
    json.member("format", "geargraph-coupling-check");
    json.member("version", 1);
    labels("motors", coupling.motors);
    labels("joints", coupling.joints);
    json.member("right", std::none_of(findings.begin(), findings.end(),
                                      [](const CouplingFinding& each) { return each.isError; }));
    json.key("findings");
    json.beginArray();
    for (const CouplingFinding& each : findings) {
      json.beginObject(JsonWriter::Layout::row);
      json.member("name", each.name);
      json.member("error", each.isError);
      json.member("message", each.sentence);
      json.endObject();
    }
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

}  // namespace geargraph
