#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "ui/teeth_panel/teeth_service.h"

namespace geargraph {

/// The choices of teeth, the best first until they are sorted by another column: teeth by wheel, for each
/// wished ratio the exact number, a decimal and the error, the numbers of planets that go in, hunting teeth
/// and efficiencies. Where none is within the bounds, the nearest one.
class ChoicesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum class Kind { rank, wheel, ratio, decimal, error, planets, hunting, efficiency, backward };
  struct Column {
    Kind kind = Kind::rank;
    std::size_t at = 0;  ///< the wheel or the ratio
  };
  enum Role {
    PlaceRole = Qt::UserRole,  ///< double, of errors: where it is in the tolerance, -1 to 1; else nothing
    UndercutRole,              ///< bool, of wheels: a rack would undercut it
    TicksRole,                 ///< QVariantList of bool, of hunting: by pair of wheels
    ShareRole,                 ///< double, of efficiencies: 0 to 1; nothing where there is none
    StrongRole,                ///< bool: what is looked at first
    FineRole,                  ///< bool: a ratio that is met exactly
  };

  using QAbstractTableModel::QAbstractTableModel;

  /// Shows what was found; null: no rows.
  void setResult(const TeethResultPtr& result);
  [[nodiscard]] const TeethChoice& choiceAt(int row) const;
  /// The number of a row's choice, 1 for the best; 0 for one that is nearest, and beyond the bounds.
  [[nodiscard]] int rankAt(int row) const;
  /// The row with these teeth by wheel; -1: none.
  [[nodiscard]] int rowOf(const std::vector<int>& teeth) const;
  [[nodiscard]] Column columnAt(int column) const { return m_columns[static_cast<std::size_t>(column)]; }
  /// The table as it is sorted, with exact numbers, for other programs.
  [[nodiscard]] QString csv() const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;
  void sort(int column, Qt::SortOrder order) override;

 private:
  [[nodiscard]] const TeethProblem& problem() const { return *m_result->problem; }
  void makeColumns();
  void makePairs();
  /// Is it one of the wheels by which meant teeth differ from the drawn ones?
  [[nodiscard]] bool isChanged(const TeethChoice& choice, std::size_t wheel) const;
  [[nodiscard]] bool isBefore(const TeethChoice& one, const TeethChoice& other, Column column) const;
  [[nodiscard]] QString textOf(const TeethChoice& choice, int row, Column column) const;
  [[nodiscard]] QString tipOf(const TeethChoice& choice, Column column) const;
  [[nodiscard]] QString headOf(Column column) const;
  [[nodiscard]] QString tipOfHead(Column column) const;
  [[nodiscard]] QVariant placeOf(const TeethChoice& choice, std::size_t ratio) const;
  [[nodiscard]] QString csvCell(const TeethChoice& choice, int row, Column column) const;

  TeethResultPtr m_result;
  std::vector<const TeethChoice*> m_rows;  ///< the best first
  std::vector<std::size_t> m_order;        ///< positions in m_rows, by row
  std::vector<Column> m_columns;
  QStringList m_marks;  ///< of wheels
  QStringList m_names;
  std::vector<std::size_t> m_pairs;  ///< one mesh for each two wheels that mesh
};

/// "exact", or "+0.184 %" with three decimals rounded from the fraction.
[[nodiscard]] QString errorText(const Rational& error);

}  // namespace geargraph
