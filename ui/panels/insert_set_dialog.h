#pragma once

#include <QDialog>

#include "core/mechanism/model/mechanism.h"

class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;

namespace geargraph {

class SetForm;
class SetPreview;

/// Inserts a complete gear set: choose a kind, enter the requirements, see the preview, insert. Not modal.
class InsertSetDialog : public QDialog {
  Q_OBJECT

 public:
  explicit InsertSetDialog(QWidget* parent = nullptr);

 signals:
  void insertWanted(const geargraph::Mechanism& set);
  /// A whole gearbox is wanted instead: the gearbox designer.
  void designWanted();

 private:
  void addKind(const QString& name, SetForm* form);
  void renew();
  [[nodiscard]] const SetForm& form() const;

  QListWidget* m_kinds;
  QStackedWidget* m_forms;
  SetPreview* m_preview;
  QLabel* m_summary;
  QPushButton* m_insert;
};

}  // namespace geargraph
