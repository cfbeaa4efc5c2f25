#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "core/presentation/exporters/exporters.h"

class QFormLayout;
class QLineEdit;

namespace geargraph {

/// A field for each option of an exporter, by its type: a box for a flag, a list of choices, a line for a
/// number with its unit or for a text. Fields are named as their options. Lines take arithmetic and, where
/// the option has a unit, other units of the same quantity.
class ExportOptionsForm : public QWidget {
  Q_OBJECT

 public:
  explicit ExportOptionsForm(const Exporter& exporter, QWidget* parent = nullptr);

  /// The options that differ from what holds without them.
  [[nodiscard]] OptionValues options() const;
  /// Options without a field are left out.
  void setOptions(const OptionValues& given);
  /// What is usual again.
  void reset();
  [[nodiscard]] bool isUsual() const { return options().options == m_usual.options; }

 signals:
  void changed();

 private:
  struct Field {
    const ExportOption* option;
    std::function<QString()> value;            ///< empty: what holds without it
    std::function<void(const QString&)> show;  ///< empty: what is usual
  };

  void add(const ExportOption& option, QFormLayout& form);
  QWidget* flagField(const ExportOption& option);
  QWidget* choiceField(const ExportOption& option);
  QWidget* lineField(const ExportOption& option);
  void mark(QLineEdit& line, const ExportOption& option);

  std::vector<Field> m_fields;
  OptionValues m_usual;
};

/// A typed number of an option in its unit, as the exporter reads it: "5 ms" gives "1/200" where the unit is
/// s; a decimal comma is a point. Empty for what is no number.
[[nodiscard]] QString exportedNumber(const QString& typed, std::string_view unit);

}  // namespace geargraph
