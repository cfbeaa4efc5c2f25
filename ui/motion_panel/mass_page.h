#pragma once

#include <QWidget>

#include "ui/document/document.h"
#include "ui/forces/linked_table.h"
#include "ui/motion_panel/dynamics_service.h"

namespace geargraph {
class NumberField;
}  // namespace geargraph

namespace geargraph {

/// The masses of the links as a table with editable masses, the density of all solids, and gravity. Every
/// change is an undoable edit; spinning a field until it is left is one step.
class MassPage : public QWidget {
  Q_OBJECT

 public:
  MassPage(Document* document, Selection* selection, QWidget* parent = nullptr);

  /// Shows the dynamics; null: no table.
  void show(const DynamicsPtr& dynamics);
  [[nodiscard]] LinkedTable& table() { return *m_table; }
  [[nodiscard]] ValueTableModel& model() { return *m_model; }
  /// Sets the link's stated mass; none: from its solids. False if it is rejected.
  bool setMass(int row, const std::optional<Number>& mass, quint64 gesture);
  /// The stated mass of a row's link.
  [[nodiscard]] std::optional<Number> statedMass(int row) const;

 private:
  QWidget* makeFields();
  NumberField* makeField(const char* name, const QString& tip, QWidget* parent);
  void setDensity(const std::optional<Number>& density);
  void setGravity(std::size_t component, const Number& value);
  void showFields();
  [[nodiscard]] const Link* linkAt(int row) const;

  Document* m_document;
  ValueTableModel* m_model;
  LinkedTable* m_table;
  NumberField* m_density = nullptr;
  std::array<NumberField*, 3> m_gravity{};
  quint64 m_gesture = 0;
};

}  // namespace geargraph
