#pragma once

#include <QDialog>

#include "core/foundations/files/csv.h"

class QCheckBox;
class QComboBox;

namespace geargraph {

/// Asks for the CSV options of a table, those of `geargraph-cli export --to csv`; the file is chosen
/// afterwards. The choice is remembered. Not modal.
class CsvDialog final : public QDialog {
  Q_OBJECT

 public:
  /// `table`: name of the table, for the title.
  explicit CsvDialog(const QString& table, QWidget* parent = nullptr);

  [[nodiscard]] CsvOptions options() const;

 private:
  void remember() const;

  QComboBox* m_separator;
  QComboBox* m_decimal;
  QCheckBox* m_labels;
  QCheckBox* m_mark;
};

}  // namespace geargraph
