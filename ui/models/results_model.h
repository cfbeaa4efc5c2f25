#pragma once

#include <QAbstractTableModel>

#include "core/theory/analysis/analysis.h"
#include "ui/models/link_text.h"
#include "ui/models/speed_unit.h"

namespace geargraph {

/// The solution of the newest snapshot as a table [AU, Eqs. (23), (25)]: a row for each joint that is not an
/// input; its name, its rate for one unit of each input, and its rate now.
///
/// Entries are decimals at first, fractions once the exact solution is available, and symbols in the gear
/// ratios if wanted and within their size limit.
class ResultsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Role {
    ZeroRole = Qt::UserRole,  ///< bool: the coefficient is exactly 0
    JointLabelRole,           ///< QString: of the row's joint
    LinkLabelRole,            ///< int: of the joint's head link
    LinkColorRole,            ///< int: the number of its colour
    SymbolRole,               ///< bool: the text is a formula in the gear ratios
  };

  using QAbstractTableModel::QAbstractTableModel;

  void setSnapshot(const SnapshotPtr& snapshot);
  /// Sets the document that names of links are taken from.
  void setNames(const MechanismPtr& newest);
  void setSymbolic(bool symbolic);
  [[nodiscard]] bool isSymbolic() const { return m_symbolic; }
  /// Sets the unit of the current rates; the coefficients are dimensionless, unless a joint slides.
  void setUnit(const SpeedUnit& unit);
  /// Is the symbolic solution available?
  [[nodiscard]] bool hasSymbols() const;

  [[nodiscard]] int inputCount() const;
  /// The joint of a row, of an input (by ordinal). @pre the row or input exists
  [[nodiscard]] ElementId outputAt(int row) const;
  [[nodiscard]] ElementId inputAt(int input) const;
  /// The ratio output : input and its inverse in one line, if there is one input and the row depends on it:
  /// "joint 9 (carrier) : joint 8 (sun) = 1/4 (0.25), inverse 4"; else empty. The speeds are relative.
  [[nodiscard]] QString ratioText(int row) const;
  /// The default row of ratioText(): the only joint on the ground other than the input; -1 if there are
  /// several or none.
  [[nodiscard]] int ratioRow() const;
  /// The text of a row's first cell with the link's name shortened to `name`; empty: without a name.
  [[nodiscard]] QString rowText(int row, const QString& name) const;
  /// The name of a row's link in that text; empty if it shows none.
  [[nodiscard]] QString rowName(int row) const;
  /// The head link of a row's joint.
  [[nodiscard]] ElementId linkAt(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  /// For the column of an input: the joint's label.
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

 private:
  [[nodiscard]] const LiveSolution* solution() const;
  /// Ordinals in the snapshot's digraph, where labels and ends need no search.
  [[nodiscard]] int jointAt(int row) const { return solution()->outputs[static_cast<std::size_t>(row)]; }
  [[nodiscard]] int linkNodeAt(int row) const { return m_snapshot->graph->turningEdge(jointAt(row)).head; }
  [[nodiscard]] int tailNodeAt(int row) const { return m_snapshot->graph->turningEdge(jointAt(row)).tail; }
  [[nodiscard]] QString rowText(int row) const;
  /// The motion that a joint's rate is: that of its head link.
  [[nodiscard]] QString jointMotion(int joint) const;
  [[nodiscard]] QString motionTip(int row) const;
  [[nodiscard]] std::size_t at(int row, int input) const;
  [[nodiscard]] const RationalFunction* symbolAt(int row, int input) const;
  [[nodiscard]] QString coefficient(int row, int input) const;
  /// With its unit where joints slide.
  [[nodiscard]] QString rateNow(int row, bool asDecimal) const;
  /// Of the exact solution; none where there is no such yet.
  [[nodiscard]] std::optional<PiNumber> exactEntry(std::size_t at) const;
  [[nodiscard]] std::optional<PiNumber> exactRate(int joint) const;
  [[nodiscard]] bool slidesAt(int joint) const;
  /// The ordinal of the reference joint of ratios; -1: none.
  [[nodiscard]] int referenceJoint() const;
  [[nodiscard]] QString headOfRates() const;
  [[nodiscard]] bool isZero(int row, int input) const;

  SnapshotPtr m_snapshot;
  LinkNames m_names;
  SpeedUnit m_unit;
  bool m_symbolic = true;
};

}  // namespace geargraph
