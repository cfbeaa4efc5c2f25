#pragma once

#include <QAbstractTableModel>

#include "core/theory/analysis/analysis.h"
#include "core/theory/states/relative_speed.h"
#include "ui/models/link_text.h"
#include "ui/models/speed_unit.h"

namespace geargraph {

/// The angular velocities of the links relative to the ground or to another link, in the reference pose: the
/// exact speeds about their axes, and the vector in the base frame.
class LinkSpeedsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Role {
    LinkColorRole = Qt::UserRole,  ///< int: the number of its colour
  };
  enum Column { linkColumn, aboutColumn, xColumn, yColumn, zColumn, columnTotal };

  using QAbstractTableModel::QAbstractTableModel;

  void setSnapshot(const SnapshotPtr& snapshot);
  void setUnit(const SpeedUnit& unit);
  /// Sets the document that names of links are taken from.
  void setNames(const MechanismPtr& newest);
  /// Sets the link that speeds are relative to; none, or a link that no longer exists: the ground.
  void setObserver(const std::optional<LinkId>& observer);
  [[nodiscard]] ElementId linkAt(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

 private:
  /// Are there exact rates, with or without powers of pi?
  [[nodiscard]] bool hasExactRates() const;
  [[nodiscard]] int observerNode() const;
  /// @pre hasExactRates()
  [[nodiscard]] std::vector<SpeedAboutOf<PiNumber>> absoluteOf(int link) const;
  [[nodiscard]] std::vector<SpeedAboutOf<PiNumber>> speedOf(int link) const;
  /// The reference speed of ratios; std::nullopt if the unit is no ratio, or the reference link is at rest or
  /// turns about several axes.
  [[nodiscard]] std::optional<PiNumber> referenceSpeed() const;
  [[nodiscard]] QString aboutText(const SpeedAboutOf<PiNumber>& about,
                                  const std::optional<PiNumber>& reference) const;
  [[nodiscard]] QString aboutText(int link) const;
  [[nodiscard]] QString componentText(int link, int component) const;

  SnapshotPtr m_snapshot;
  LinkNames m_names;
  SpeedUnit m_unit;
  std::optional<LinkId> m_observer;
};

}  // namespace geargraph
