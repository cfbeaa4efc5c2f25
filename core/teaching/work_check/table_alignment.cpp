#include "core/teaching/work_check/table_alignment.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr int kMaxAlignmentSteps = 200'000;

/// A row as positions in a list of values that the other row has too; -1: none of them.
using Codes = std::vector<int>;

/// One of each number: formulas that agree for these teeth are told apart when the order is found.
std::vector<DerivedEntry> distinct(const std::vector<DerivedEntry>& entries, Codes& codes) {
  std::vector<DerivedEntry> values;
  for (const DerivedEntry& entry : entries) {
    const auto same = std::find_if(values.begin(), values.end(),
                                   [&](const DerivedEntry& value) { return value.value == entry.value; });
    codes.push_back(static_cast<int>(same - values.begin()));
    if (same == values.end()) values.push_back(entry);
  }
  return values;
}

/// The derived entries times the factor that turns `derived` into `written`, and the written row's numbers
/// compared as numbers where the reference is one.
struct Scale {
  RationalFunction function;
  Rational value;
  Rational slack;
  bool isNumber = false;

  Scale(const Vocabulary& vocabulary, const WrittenAmount& written, const DerivedEntry& derived)
      : function(written.value / derived.function), value(vocabulary.atTeeth(written.value) / derived.value) {
    slack = written.slack / derived.value.abs();
    const bool isConstant = derived.function == vocabulary.constant(derived.value);
    isNumber = written.hasNumbers || (!written.hasRatios && !isConstant);
  }
  [[nodiscard]] DerivedEntry of(const DerivedEntry& entry) const {
    return {entry.function * function, entry.value * value, entry.hasFunction};
  }
  [[nodiscard]] TableAgreement agreement(const Vocabulary& vocabulary, WrittenAmount written,
                                         const DerivedEntry& entry) const {
    written.hasNumbers = written.hasNumbers || isNumber;
    written.slack += entry.value.abs() * slack;
    return agreementOf(vocabulary, written, of(entry));
  }
};

/// Finds rows and columns by refinement: columns stay together while the rows matched so far cannot tell
/// them apart.
class AlignmentSearch {
 public:
  AlignmentSearch(const Vocabulary& vocabulary, const WrittenAmounts& written, const DerivedTable& derived,
                  RowFreedom freedom, const std::stop_token& stop)
      : m_vocabulary(vocabulary), m_written(written), m_derived(derived), m_freedom(freedom), m_stop(stop) {
    for (const auto& row : derived.entries) m_values.push_back(distinct(row, m_codes.emplace_back()));
  }

  std::optional<Alignment> find(const LabelPositions& labels, FreeOrder order) {
    const auto height = static_cast<std::size_t>(m_derived.height());
    const auto width = static_cast<std::size_t>(m_derived.width());
    m_rows.assign(height, 0);
    std::iota(m_rows.begin(), m_rows.end(), 0);
    m_areRowsFree = !labels.rows && (order == FreeOrder::rows || order == FreeOrder::both);
    if (labels.rows) m_rows = *labels.rows;
    m_isTaken.assign(height, 0);
    m_turned.assign(height, 0);
    std::vector<int> ofWritten(width, 0);
    std::vector<int> ofDerived(width, 0);
    if (labels.columns || order == FreeOrder::none || order == FreeOrder::rows) {
      std::iota(ofDerived.begin(), ofDerived.end(), 0);
      ofWritten = labels.columns ? *labels.columns : ofDerived;
    }
    if (!matchFrom(0, ofWritten, ofDerived)) return std::nullopt;
    return Alignment{m_rows, columnsOf(m_lastWritten, m_lastDerived), m_turned};
  }

 private:
  bool matchFrom(std::size_t row, const std::vector<int>& ofWritten, const std::vector<int>& ofDerived) {
    if (row == m_rows.size()) {
      m_lastWritten = ofWritten;
      m_lastDerived = ofDerived;
      return true;
    }
    if (!m_areRowsFree) return tryRow(row, m_rows[row], ofWritten, ofDerived);
    const auto count = static_cast<int>(m_rows.size());
    // Rows of one column may be equal for these teeth and not as formulas: first those that are so.
    const auto& cells = m_written[row];
    const bool areFormulas =
        m_freedom == RowFreedom::none &&
        std::any_of(cells.begin(), cells.end(), [](const WrittenAmount& cell) { return cell.hasRatios; });
    for (const bool byFormula : {true, false}) {
      if (byFormula && !areFormulas) continue;
      for (int i = 0; i < count; ++i) {
        const int candidate = (static_cast<int>(row) + i) % count;
        if (m_isTaken[static_cast<std::size_t>(candidate)] != 0) continue;
        if (areFormulas && byFormula != agreesAsFormulas(row, candidate)) continue;
        if (tryRow(row, candidate, ofWritten, ofDerived)) return true;
      }
    }
    return false;
  }

  /// Is each written entry, as a formula, an entry of the derived row?
  [[nodiscard]] bool agreesAsFormulas(std::size_t row, int candidate) const {
    const auto& entries = m_derived.entries[static_cast<std::size_t>(candidate)];
    return std::all_of(m_written[row].begin(), m_written[row].end(), [&](const WrittenAmount& cell) {
      return std::any_of(entries.begin(), entries.end(), [&](const DerivedEntry& entry) {
        return agreementOf(m_vocabulary, cell, entry) == TableAgreement::full;
      });
    });
  }

  bool tryRow(std::size_t row, int candidate, const std::vector<int>& ofWritten,
              const std::vector<int>& ofDerived) {
    Codes written;
    for (int turn = 0; code(row, candidate, turn, written); ++turn) {
      if (++m_steps > kMaxAlignmentSteps || m_stop.stop_requested()) return false;
      if (std::find(written.begin(), written.end(), -1) != written.end()) continue;
      std::vector<int> nextWritten = ofWritten;
      std::vector<int> nextDerived = ofDerived;
      if (!refine(nextWritten, nextDerived, written, m_codes[static_cast<std::size_t>(candidate)])) continue;
      m_isTaken[static_cast<std::size_t>(candidate)] = 1;
      if (matchFrom(row + 1, nextWritten, nextDerived)) {
        m_rows[row] = candidate;
        m_turned[row] = turn > 0 ? 1 : 0;
        return true;
      }
      m_isTaken[static_cast<std::size_t>(candidate)] = 0;
    }
    return false;
  }

  /// The written row as values of a derived one, in the way number `turn` that the freedom allows; false
  /// where there are no more.
  bool code(std::size_t row, int candidate, int turn, Codes& codes) const {
    const auto& values = m_values[static_cast<std::size_t>(candidate)];
    const auto& cells = m_written[row];
    codes.assign(cells.size(), -1);
    const int most = m_freedom == RowFreedom::none   ? 1
                     : m_freedom == RowFreedom::sign ? 2
                                                     : static_cast<int>(values.size());
    if (turn >= most) return false;
    const auto codeBy = [&](const auto& agreement) {
      for (std::size_t k = 0; k < cells.size(); ++k) {
        for (std::size_t v = 0; v < values.size() && codes[k] < 0; ++v) {
          if (agreement(cells[k], values[v]) != TableAgreement::none) codes[k] = static_cast<int>(v);
        }
      }
    };
    if (m_freedom != RowFreedom::multiple) {
      codeBy([&](const WrittenAmount& cell, const DerivedEntry& value) {
        return agreementOf(m_vocabulary, cell, turn == 0 ? value : value.negated());
      });
      return true;
    }
    const auto first = std::find_if(cells.begin(), cells.end(),
                                    [&](const WrittenAmount& cell) { return !cell.value.isZero(); });
    const DerivedEntry& reference = values[static_cast<std::size_t>(turn)];
    if (first == cells.end() || reference.value.isZero()) return true;
    const Scale scale(m_vocabulary, *first, reference);
    codeBy([&](const WrittenAmount& cell, const DerivedEntry& value) {
      return scale.agreement(m_vocabulary, cell, value);
    });
    return true;
  }

  /// Parts the columns by the codes of one more row; false where the parts differ in size.
  static bool refine(std::vector<int>& ofWritten, std::vector<int>& ofDerived, const Codes& written,
                     const Codes& derived) {
    std::map<std::pair<int, int>, std::pair<int, int>>
        parts;  // its number, and derived minus written columns
    const auto part = [&](int last, int code, int change) {
      const auto number = static_cast<int>(parts.size());
      auto& entry = parts.try_emplace({last, code}, number, 0).first->second;
      entry.second += change;
      return entry.first;
    };
    for (std::size_t k = 0; k < ofDerived.size(); ++k) ofDerived[k] = part(ofDerived[k], derived[k], 1);
    for (std::size_t k = 0; k < ofWritten.size(); ++k) ofWritten[k] = part(ofWritten[k], written[k], -1);
    return std::all_of(parts.begin(), parts.end(), [](const auto& p) { return p.second.second == 0; });
  }

  /// A derived column for each written one of the same part, its own one where it is in it.
  static std::vector<int> columnsOf(const std::vector<int>& ofWritten, const std::vector<int>& ofDerived) {
    std::vector<int> columns(ofWritten.size(), -1);
    std::vector<char> isTaken(ofDerived.size(), 0);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (ofWritten[k] != ofDerived[k]) continue;
      columns[k] = static_cast<int>(k);
      isTaken[k] = 1;
    }
    for (std::size_t k = 0; k < columns.size(); ++k) {
      for (std::size_t d = 0; d < ofDerived.size() && columns[k] < 0; ++d) {
        if (isTaken[d] != 0 || ofDerived[d] != ofWritten[k]) continue;
        columns[k] = static_cast<int>(d);
        isTaken[d] = 1;
      }
    }
    return columns;
  }

  const Vocabulary& m_vocabulary;
  const WrittenAmounts& m_written;
  const DerivedTable& m_derived;
  RowFreedom m_freedom;
  std::stop_token m_stop;
  std::vector<std::vector<DerivedEntry>> m_values;  ///< of each derived row, once each
  std::vector<Codes> m_codes;                       ///< of each derived row
  std::vector<int> m_rows;
  std::vector<char> m_turned;
  std::vector<char> m_isTaken;
  bool m_areRowsFree = false;
  int m_steps = 0;
  std::vector<int> m_lastWritten;
  std::vector<int> m_lastDerived;
};

}  // namespace

bool Alignment::isNatural() const {
  return std::is_sorted(rows.begin(), rows.end()) && std::is_sorted(columns.begin(), columns.end());
}

std::optional<Alignment> alignmentOf(const Vocabulary& vocabulary, const WrittenAmounts& written,
                                     const DerivedTable& derived, RowFreedom freedom,
                                     const LabelPositions& labels, FreeOrder order,
                                     const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(static_cast<int>(written.size()) == derived.height());
  return AlignmentSearch(vocabulary, written, derived, freedom, stop).find(labels, order);
}

std::vector<DerivedEntry> scaledRow(const Vocabulary& vocabulary, const std::vector<WrittenAmount>& written,
                                    const std::vector<DerivedEntry>& derived, RowFreedom freedom,
                                    const std::vector<int>& columns) {
  std::vector<DerivedEntry> best;
  for (const int column : columns) best.push_back(derived[static_cast<std::size_t>(column)]);
  if (freedom == RowFreedom::none) return best;
  const std::vector<DerivedEntry> own = best;
  std::vector<std::vector<DerivedEntry>> ways{own};
  if (freedom == RowFreedom::sign) {
    std::vector<DerivedEntry>& turned = ways.emplace_back();
    for (const DerivedEntry& entry : own) turned.push_back(entry.negated());
  }
  for (std::size_t k = 0; k < own.size() && freedom == RowFreedom::multiple; ++k) {
    if (own[k].value.isZero() || written[k].value.isZero()) continue;
    const Scale scale(vocabulary, written[k], own[k]);
    std::vector<DerivedEntry>& scaled = ways.emplace_back();
    for (const DerivedEntry& entry : own) scaled.push_back(scale.of(entry));
  }
  std::ptrdiff_t most = -1;
  for (auto& way : ways) {
    std::ptrdiff_t agreeing = 0;
    for (std::size_t k = 0; k < way.size(); ++k) {
      agreeing += static_cast<int>(agreementOf(vocabulary, written[k], way[k]));
    }
    if (agreeing <= most) continue;
    most = agreeing;
    best = std::move(way);
  }
  return best;
}

}  // namespace geargraph
