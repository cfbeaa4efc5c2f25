#pragma once

#include <QAbstractTableModel>

#include "core/theory/analysis/analysis.h"
#include "ui/models/link_text.h"
#include "ui/models/speed_unit.h"

namespace geargraph::inline models {

/// The solution of the newest snapshot as a table [AU, Eqs. (23), (25)]: a row for each joint that is not an
/// input; its name, its rate for one unit of each input, and its rate now.
///
/// Entries are numbers at once, exact fractions when they are there, and symbols in the gear ratios where
/// they are wanted and not over their budget.
class ResultsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Role {
    ZeroRole = Qt::UserRole,  ///< bool: the coefficient is exactly 0
    JointLabelRole,           ///< QString: of the row's joint
    LinkLabelRole,            ///< int: of the link that the joint carries
    SymbolRole,               ///< bool: the text is a formula in the gear ratios
  };

  using QAbstractTableModel::QAbstractTableModel;

  void setSnapshot(const SnapshotPtr& snapshot);
  /// The document that names of links are taken from.
  void setNames(const MechanismPtr& newest);
  void setSymbolic(bool symbolic);
  [[nodiscard]] bool isSymbolic() const { return m_symbolic; }
  /// Of the rates now; the coefficients are pure numbers.
  void setUnit(const SpeedUnit& unit);
  /// Are there symbols to be shown?
  [[nodiscard]] bool hasSymbols() const;

  [[nodiscard]] int inputCount() const;
  /// By their ordinals. @pre the row or input is there
  [[nodiscard]] ElementId outputAt(int row) const;
  [[nodiscard]] ElementId inputAt(int input) const;
  /// The ratio output : input and its inverse in one line, where there is one input and the row turns with
  /// it: "joint 9 (carrier) : joint 8 (sun) = 1/4 (0.25), inverse 4"; else empty. Of relative speeds.
  [[nodiscard]] QString ratioText(int row) const;
  /// The row that such a ratio is about unless another is chosen: the only joint that turns on the ground
  /// beside the input; -1 where there are several or none.
  [[nodiscard]] int ratioRow() const;
  /// The link that the joint of a row carries: its head.
  [[nodiscard]] ElementId linkAt(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  /// Of an input's column: the joint's label.
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

 private:
  [[nodiscard]] const LiveSolution* solution() const;
  /// By their ordinals in the snapshot's digraph, which knows labels and ends without a search.
  [[nodiscard]] int jointAt(int row) const { return solution()->outputs[static_cast<std::size_t>(row)]; }
  [[nodiscard]] int linkNodeAt(int row) const { return m_snapshot->graph->turningEdge(jointAt(row)).head; }
  [[nodiscard]] int tailNodeAt(int row) const { return m_snapshot->graph->turningEdge(jointAt(row)).tail; }
  [[nodiscard]] QString jointText(int joint) const;
  [[nodiscard]] QString rowText(int row) const;
  [[nodiscard]] QString motionTip(int row) const;
  [[nodiscard]] std::size_t at(int row, int input) const;
  [[nodiscard]] const RationalFunction* symbolAt(int row, int input) const;
  [[nodiscard]] QString coefficient(int row, int input) const;
  [[nodiscard]] QString rateNow(int row, bool asDecimal) const;
  /// The joint that ratios are taken to, by ordinal; -1: none.
  [[nodiscard]] int referenceJoint() const;
  [[nodiscard]] QString headOfRates() const;
  [[nodiscard]] bool isZero(int row, int input) const;

  SnapshotPtr m_snapshot;
  LinkNames m_names;
  SpeedUnit m_unit;
  bool m_symbolic = true;
};

}  // namespace geargraph::inline models
