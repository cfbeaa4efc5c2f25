#pragma once

#include <QAbstractTableModel>
#include <array>

#include "core/teaching/force_tables/force_table.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The shift table, one row per state of the document: its name, one column per coupling, the input and
/// output link, the exact and decimal ratio, the step from the previous state; once the torques are solved
/// also efficiency, circulating power, and the torque in each coupling's column.
///
/// Names and dots follow the document immediately, computed values with the complete snapshot of the same
/// states. Until then the last ratios of these states are kept, since they would flicker during a drag.
class StatesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Role {
    EngagedRole = Qt::UserRole,  ///< bool: the column's coupling is engaged in the row's state
    RunningRole,                 ///< bool: the row's state is engaged now
    RemarkRole,                  ///< bool: the text is the reason for the missing ratio
    HoldsRole,                   ///< QString, of headings: the constraint of the coupling, "2 = 0"
  };
  /// The columns after those of the couplings.
  enum class Tail { links, ratio, decimal, step, efficiency, backward, circulating, count };

  using QAbstractTableModel::QAbstractTableModel;

  void setMechanism(const MechanismPtr& mechanism);
  void setSnapshot(const SnapshotPtr& snapshot);
  /// Sets the torques of all states of `mechanism`; they are shown only while the document has the same
  /// states.
  void setTorques(const std::shared_ptr<const ForceTable>& torques, const MechanismPtr& mechanism);

  [[nodiscard]] const MechanismPtr& mechanism() const { return m_mechanism; }
  [[nodiscard]] const SnapshotPtr& snapshot() const { return m_snapshot; }
  [[nodiscard]] int couplingCount() const;
  /// The coupling of a column; -1 if it has none.
  [[nodiscard]] int couplingAt(int column) const;
  [[nodiscard]] bool isTail(int column, Tail tail) const;
  [[nodiscard]] bool isEngagedNow(int coupling) const;
  /// The torques of all states; null until they are solved for the document.
  [[nodiscard]] const ForceTable* torques() const;
  /// Null until the snapshot of these states is available.
  [[nodiscard]] const StateSolution* solutionAt(int row) const;
  [[nodiscard]] bool isRunning(int row) const { return m_rows[static_cast<std::size_t>(row)].isRunning; }

  /// Has this state no input or output link yet, and so no ratio?
  [[nodiscard]] bool lacksLinks(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Emits renamed(); the model changes when the document does.
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
  /// For a coupling: its name; in EngagedRole whether it is engaged now, in HoldsRole its constraint.
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

 signals:
  void renamed(int row, const QString& name);
  void computed();  ///< after dataChanged() for what a snapshot has changed

 private:
  /// The displayed values of a state other than names and dots.
  struct Row {
    std::array<QString, static_cast<std::size_t>(Tail::count)> tails;
    std::vector<QString> torques;  ///< by coupling
    bool isRunning = false;
    bool isRemark = false;
    friend bool operator==(const Row&, const Row&) = default;
  };

  [[nodiscard]] std::vector<Row> rowsNow() const;
  void tellChange(int row, const Row& before);
  void updateRows();
  [[nodiscard]] QString accessibleText(const QModelIndex& index) const;
  [[nodiscard]] QString textOf(int row, int column) const;
  [[nodiscard]] QString ratioText(int row) const;
  [[nodiscard]] const ForceCell* torqueCell(int row, int coupling) const;
  [[nodiscard]] const ForceCell* shiftCell(int row, ShiftColumn column) const;
  [[nodiscard]] QString torqueTip(int row, int coupling) const;
  [[nodiscard]] QString tailTip(int row, int column) const;
  [[nodiscard]] QString tailText(int row, Tail tail) const;
  [[nodiscard]] QString linkText(const std::optional<LinkId>& link) const;

  MechanismPtr m_mechanism;
  SnapshotPtr m_snapshot;
  std::shared_ptr<const ForceTable> m_torques;
  MechanismPtr m_torquesOf;
  std::vector<Row> m_rows;
};

}  // namespace geargraph
