#pragma once

#include <QDialog>

#include "core/foundations/files/csv.h"

class QCheckBox;
class QComboBox;

namespace geargraph::inline mainwindow {

/// Asks how a table is to be written as CSV, with the options of `geargraph-cli export --to csv`; the file is
/// asked for afterwards. What is chosen is proposed the next time. It does not lock the window.
class CsvDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `table`: what is exported, for the title.
  explicit CsvDialog(const QString& table, QWidget* parent = nullptr);

  [[nodiscard]] CsvOptions options() const;

 private:
  void remember() const;

  QComboBox* m_separator;
  QComboBox* m_decimal;
  QCheckBox* m_labels;
  QCheckBox* m_mark;
};

}  // namespace geargraph::inline mainwindow
