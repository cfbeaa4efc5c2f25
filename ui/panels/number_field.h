#pragma once

#include <QLineEdit>
#include <optional>
#include <string>

#include "core/mechanism/model/number.h"

namespace geargraph::inline panels {

/// A number to type (12, 0.5, 22/7) or to spin, by the arrow keys, the wheel or the arrows at its end. What
/// is no number turns red and changes nothing. Where the locale writes a decimal comma it may be typed.
class NumberField : public QLineEdit {
  Q_OBJECT

 public:
  explicit NumberField(QWidget* parent = nullptr);

  /// Whole numbers from `least` to `most` only.
  void setWhole(int least, int most);
  /// A length in this unit of the document's: others may be typed and are converted (lengthFromText()).
  void setLengthUnit(const std::string& unit);
  void setStep(const Rational& step) { m_step = step; }
  /// What stands in the field while it has no number: "auto", "several".
  void setEmptyText(const QString& text) { setPlaceholderText(text); }
  /// May the field be emptied? Then edited() says nothing.
  void setOptional(bool optional) { m_optional = optional; }

  /// Shows the document's number; leaves the text alone while somebody types that number.
  void setNumber(const std::optional<Number>& number);
  [[nodiscard]] std::optional<Number> number() const { return m_number; }
  /// The number of edited() was not accepted: what was typed turns red, and gives way to the number of the
  /// next setNumber() when the field is left.
  void reject(const QString& why);

 signals:
  void edited(const std::optional<geargraph::Number>& number);
  void wrongChanged(const QString& why);  ///< why what is typed is no such number; empty: it is one
  void editingStarted();                  ///< what follows until the next one is one gesture

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  [[nodiscard]] QString hint() const;  ///< while nothing is wrong
  [[nodiscard]] std::optional<Number> read(const QString& text) const;
  void onText(const QString& text);
  void spin(int steps);
  void setWrong(const QString& why);
  [[nodiscard]] QRect spinRect() const;

  std::optional<Number> m_number;
  Rational m_step = 1;
  std::optional<int> m_least;
  std::optional<int> m_most;
  std::optional<std::string> m_unit;  ///< of a length
  bool m_optional = false;
  bool m_selectOnRelease = false;
};

}  // namespace geargraph::inline panels
