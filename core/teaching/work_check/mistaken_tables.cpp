// Matrices with a mistake all over: transposed, exchanged signs, the ground's row ...

#include <algorithm>
#include <functional>

#include "core/foundations/base/translation.h"
#include "core/teaching/work_check/table_mistakes.h"

namespace geargraph {
namespace {

using Change = std::function<DerivedEntry(const DerivedEntry&)>;

DerivedTable changed(DerivedTable table, const Change& change) {
  for (auto& row : table.entries) {
    for (DerivedEntry& entry : row) entry = change(entry);
  }
  return table;
}

DerivedEntry negated(const DerivedEntry& entry) {
  return entry.negated();
}

DerivedEntry magnitude(const DerivedEntry& entry) {
  return entry.value.sign() < 0 ? entry.negated() : entry;
}

/// The same up to the freedom of its rows, in the natural order.
bool isSame(const DerivedTable& a, const DerivedTable& b) {
  if (a.height() != b.height() || a.width() != b.width()) return false;
  const RowFreedom freedom = rowFreedom(b.kind);
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    const auto agrees = [&](bool isTurned) {
      return std::equal(a.entries[i].begin(), a.entries[i].end(), b.entries[i].begin(),
                        [&](const DerivedEntry& x, const DerivedEntry& y) {
                          return x.value == (isTurned ? -y.value : y.value);
                        });
    };
    if (!agrees(false) && (freedom == RowFreedom::none || !agrees(true))) return false;
  }
  return true;
}

class MistakenTables {
 public:
  MistakenTables(const Vocabulary& vocabulary, const DerivedTable& right)
      : m_vocabulary(vocabulary), m_right(right) {}

  std::vector<MistakenTable> all() {
    const std::string symbol(paperMatrixSymbol(m_right.kind));
    add("transposed", translated("You exchange rows and columns of %1.", {symbol}), m_right.transposed());
    addGroundRow();
    addSigns();
    addTransposedSigns();
    addRatios();
    return std::move(m_all);
  }

 private:
  void add(const char* name, std::string reason, DerivedTable table) {
    if (isSame(table, m_right)) return;
    for (const MistakenTable& other : m_all) {
      if (isSame(table, other.table)) return;
    }
    m_all.push_back({name, std::move(reason), std::move(table)});
  }

  void addGroundRow() {
    const bool isFull = m_right.kind == PaperMatrix::incidence;
    if (!isFull && m_right.kind != PaperMatrix::reducedIncidence) return;
    auto other = derivedTable(m_vocabulary, isFull ? PaperMatrix::reducedIncidence : PaperMatrix::incidence);
    if (!other) return;
    other->kind = m_right.kind;
    if (isFull) {
      add("ground-row-left-out", translated("You leave out the ground: Γ⁰ keeps its row, only Γ has none."),
          *other);
    } else {
      add("ground-row-left-in",
          translated("You leave the row of the ground in: Γ has the rows of the moving links only."), *other);
    }
  }

  void addSigns() {
    switch (m_right.kind) {
      case PaperMatrix::incidence:
      case PaperMatrix::reducedIncidence:
        add("incidence-exchanged",
            translated("You exchange + and −: a column holds −1 where the arrow begins and 1 where it ends."),
            changed(m_right, negated));
        break;
      case PaperMatrix::path:
        add("walk-from-ground",
            translated("You walk from the ground to the links: the walks of Z end at the ground."),
            changed(m_right, negated));
        break;
      case PaperMatrix::cutset:
        add("cutset-as-cycle",
            translated("You take the signs of the cycles: Q holds −T transposed beside the unit matrix."),
            withMeshesTurned());
        break;
      case PaperMatrix::solution:
        add("minus-left-out",
            translated("You leave out the minus of (23): what is on the other side of the equation changes "
                       "its sign."),
            changed(m_right, negated));
        break;
      case PaperMatrix::spanningTree:
      case PaperMatrix::cycleBasis:
      case PaperMatrix::coefficients:
        break;
    }
    add("signs-left-out",
        translated("You write all entries without their signs: −1 where a walk runs against an arrow."),
        changed(m_right, magnitude));
  }

  void addTransposedSigns() {
    if (rowFreedom(m_right.kind) != RowFreedom::none || m_right.kind == PaperMatrix::solution) return;
    add("transposed",
        translated("You exchange rows and columns of %1, and + and − besides.",
                   {paperMatrixSymbol(m_right.kind)}),
        changed(m_right.transposed(), negated));
  }

  /// Γ of the meshes turned round in a cutset.
  [[nodiscard]] DerivedTable withMeshesTurned() const {
    DerivedTable table = m_right;
    const auto t = static_cast<std::size_t>(m_vocabulary.source().graph().t());
    for (auto& row : table.entries) {
      for (std::size_t column = t; column < row.size(); ++column) row[column] = row[column].negated();
    }
    return table;
  }

  /// Of P: the cycles alone, and the ratios upside down in every row.
  void addRatios() {
    if (m_right.kind != PaperMatrix::coefficients) return;
    const auto one = [&](const DerivedEntry& entry) {
      return DerivedEntry{RationalFunction::fromInteger(m_vocabulary.ring(), entry.value.sign()),
                          entry.value.sign()};
    };
    DerivedTable cycles = m_right;
    if (const auto tree = derivedTable(m_vocabulary, PaperMatrix::spanningTree)) {
      for (std::size_t i = 0; i < cycles.entries.size(); ++i) cycles.entries[i] = tree->entries[i];
      add("coefficients-left-out",
          translated("These are the rows of T: P multiplies each entry by the joint's coefficient."), cycles);
    }
    add("coefficients-left-out",
        translated("These are the signs of P alone: each is to be multiplied by the ratio of its gear."),
        changed(m_right, one));
    add("ratio-upside-down",
        translated("Your ratios are upside down: a joint on the axis of the tail's gear has i, one on the "
                   "head's has 1."),
        upsideDown());
  }

  [[nodiscard]] DerivedTable upsideDown() const {
    DerivedTable table = m_right;
    for (std::size_t mesh = 0; mesh < table.entries.size(); ++mesh) {
      for (DerivedEntry& entry : table.entries[mesh]) {
        if (entry.value.isZero()) continue;
        const bool isConstant = entry.function == m_vocabulary.constant(entry.value.sign());
        const bool isTail = !isConstant;
        entry.function = RationalFunction::power(m_vocabulary.ring(), entry.value.sign(),
                                                 static_cast<int>(mesh), isTail ? 0 : 1);
        entry.value = m_vocabulary.atTeeth(entry.function);
      }
    }
    return table;
  }

  const Vocabulary& m_vocabulary;
  const DerivedTable& m_right;
  std::vector<MistakenTable> m_all;
};

}  // namespace

std::vector<MistakenTable> mistakenTables(const Vocabulary& vocabulary, const DerivedTable& right) {
  return MistakenTables(vocabulary, right).all();
}

}  // namespace geargraph
