#pragma once

#include <QAbstractListModel>
#include <set>

#include "core/foundations/base/diagnostic.h"

namespace geargraph {

/// The diagnostics of an analysis or of a file as a list, errors first.
class DiagnosticModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role {
    SeverityRole = Qt::UserRole,  ///< int(Severity); info for unfinished drawings
    CodeRole,                     ///< QString: "turning-loop"
    UnfinishedRole,               ///< bool: about a drawing that is not complete yet
    PlaceRole,                    ///< QString: "line 3, column 7", "/links/2/id", or empty
  };

  using QAbstractListModel::QAbstractListModel;

  void setDiagnostics(Diagnostics diagnostics);
  [[nodiscard]] const Diagnostics& diagnostics() const { return m_diagnostics; }
  /// The elements that a diagnostic names.
  [[nodiscard]] std::set<ElementId> elementsOf(const QModelIndex& index) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

 private:
  Diagnostics m_diagnostics;
};

}  // namespace geargraph
