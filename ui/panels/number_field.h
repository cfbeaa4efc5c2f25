#pragma once

#include <QAbstractSpinBox>
#include <QTimer>
#include <QVariant>
#include <optional>
#include <string>

#include "core/mechanism/model/number.h"
#include "core/mechanism/model/quantity.h"

namespace geargraph {

/// A spin box for exact numbers (12, 0.5, 22/7, 2*3), stepped by the arrow keys, the wheel or its arrow
/// buttons. Typed text is committed by Return, by leaving the field or after kPause, so that typing 1000 does
/// not produce trains of 1, 10 and 100 teeth; Esc discards it. Invalid text turns red and changes nothing. A
/// decimal comma is accepted, except where the locale uses a decimal point and the comma could group
/// thousands (1,000). Undo and redo act on the document unless typed text is not committed yet.
class NumberField : public QAbstractSpinBox {
  Q_OBJECT
  // The properties that QAccessibleAbstractSpinBox uses: "stepSize", not QSpinBox's "singleStep".
  Q_PROPERTY(QVariant value READ value WRITE setValue)
  Q_PROPERTY(QVariant minimum READ minimum)
  Q_PROPERTY(QVariant maximum READ maximum)
  Q_PROPERTY(QVariant stepSize READ stepSize)

 public:
  static constexpr int kPause = 600;  ///< ms

  explicit NumberField(QWidget* parent = nullptr);

  /// Accepts only integers from `least` to `most`.
  void setWhole(int least, int most);
  /// Makes the field a length in this unit; lengths in other units may be typed and are converted
  /// (lengthFromText()).
  /// None: it is no length again.
  void setLengthUnit(const std::optional<std::string>& unit);
  /// The same for a speed in such lengths a second: "2 m/s", "30 mm/min" are converted.
  void setLengthRate(const std::string& unit);
  /// Makes the field a quantity; one that is typed with a unit is converted (quantityFromText()). `shownIn`:
  /// the unit of the field's numbers, in that of the quantity.
  void setQuantity(Quantity quantity, const Rational& shownIn = 1);
  void setStep(const Rational& step) { m_step = step; }
  /// The text shown without a number: "auto", "several".
  void setEmptyText(const QString& text);
  /// May the field be emptied? Then edited() has no number.
  void setOptional(bool optional) { m_optional = optional; }

  /// Shows the document's number; leaves the text alone while the user types that number.
  void setNumber(const std::optional<Number>& number);
  [[nodiscard]] std::optional<Number> number() const { return m_number; }
  /// To be called if the number of edited() was rejected: the typed text turns red, and is replaced by the
  /// former number when the field loses focus.
  void reject(const QString& why);
  /// Commits the typed text now, without a pause in typing.
  void commit();
  /// Is edited() being emitted?
  [[nodiscard]] bool isCommitting() const { return m_isCommitting; }

  /// Changes the number by `steps` times the step, within the bounds; without a number it starts from 0.
  void stepBy(int steps) override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

  [[nodiscard]] QVariant value() const;
  void setValue(const QVariant& value);  ///< as if typed
  [[nodiscard]] QVariant minimum() const { return m_least ? QVariant(*m_least) : QVariant(); }
  [[nodiscard]] QVariant maximum() const { return m_most ? QVariant(*m_most) : QVariant(); }
  [[nodiscard]] QVariant stepSize() const { return m_step.toDouble(); }

 signals:
  void edited(const std::optional<geargraph::Number>& number);
  void wrongChanged(const QString& why);  ///< why the text is invalid; empty: it is valid
  void editingStarted();                  ///< edits until the next one are one gesture

 protected:
  [[nodiscard]] StepEnabled stepEnabled() const override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  [[nodiscard]] static QString textOf(const Number& number);
  [[nodiscard]] QString hint() const;  ///< shown while the text is valid
  [[nodiscard]] std::optional<Number> read(const QString& text) const;
  [[nodiscard]] QSize sizeAround(const QSize& text) const;
  /// Why the field does not accept this number; empty if it does.
  [[nodiscard]] QString objectionTo(const std::optional<Number>& number) const;
  void onText(const QString& text);
  void tellOf(const std::optional<Number>& number);
  void drop();
  void showNumber();
  void setWrong(const QString& why);
  void markWrong(bool isWrong);

  std::optional<Number> m_number;
  std::optional<Number> m_before;  ///< the former number, while edited() is emitted
  QTimer m_pause;
  bool m_isPending = false;  ///< typed text is not committed
  bool m_isCommitting = false;
  Rational m_step = 1;
  std::optional<int> m_least;
  std::optional<int> m_most;
  std::optional<std::string> m_unit;  ///< of a length
  bool m_isRate = false;              ///< it is a length a second
  [[nodiscard]] std::optional<Number> readRate(const std::string& typed) const;
  Quantity m_quantity = Quantity::number;
  Rational m_shownIn = 1;
  bool m_optional = false;
  bool m_selectOnRelease = false;
};

}  // namespace geargraph
