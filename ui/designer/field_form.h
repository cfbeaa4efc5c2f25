#pragma once

#include <QWidget>
#include <array>
#include <map>

class QFormLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QSpinBox;
class QVBoxLayout;

namespace geargraph {
class JsonWriter;
}  // namespace geargraph

namespace geargraph {

/// The ratios in a typed or pasted text, as wishes have them: separated by blanks, semicolons, or commas
/// that are no decimal signs; "4,17 2,34" and "4.17, 2.34" are the same two.
[[nodiscard]] QStringList ratiosIn(const QString& text);
/// Numbers with the decimal sign in use: "4,17 2,34".
[[nodiscard]] QString localNumbers(const char* numbers);
/// With a point as decimal sign, as files have it, and with the sign of a keyboard.
[[nodiscard]] std::string plainNumber(QString text);
/// A number of percent as a part of 1, exactly; as typed where it is none, so that the fault names it.
[[nodiscard]] std::string partOfOne(const QString& percent);

/// A wish as a column of fields under headings, with what is wrong below each group of them.
class FieldForm : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;

  /// The width, with a scroll bar beside it, at which no field is cut: the form is not scrolled sideways, and
  /// its words are longer in other languages. At least `least`.
  [[nodiscard]] int roomFor(int least) const;

 signals:
  void changed();
  /// Return was pressed in a field of one line.
  void searchWanted();

 protected:
  /// Two spin boxes or lines for a least and a largest number.
  using Numbers = std::array<QSpinBox*, 2>;

  [[nodiscard]] QVBoxLayout* makeColumn();
  QFormLayout* addForm(QVBoxLayout& column, const QString& heading);
  QSpinBox* spin(const char* name, int least, int most, int value);
  QLineEdit* line(const char* name, const QString& text);
  QPlainTextEdit* ratiosField(const char* name, const QString& tip);
  /// "wishBrakesFrom" and "wishBrakesTo" of the name "wishBrakes".
  Numbers range(const char* name, int least, int most, std::array<int, 2> values);
  static QHBoxLayout* fromTo(QWidget* from, QWidget* to);
  static void writeRange(JsonWriter& json, const char* name, const Numbers& ends);
  static void writeWhole(JsonWriter& json, const char* name, const QSpinBox& box);

  /// The place of what is wrong with a group of fields.
  void addFault(QVBoxLayout& column, int group);
  void clearFaults();
  /// The first one of a group is shown.
  void showFault(int group, const QString& why);
  virtual void onEdited();

 private:
  std::map<int, QLabel*> m_faults;
};

}  // namespace geargraph
