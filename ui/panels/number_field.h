#pragma once

#include <QAbstractSpinBox>
#include <QTimer>
#include <QVariant>
#include <optional>
#include <string>

#include "core/mechanism/model/number.h"

namespace geargraph::inline panels {

/// A number to type (12, 0.5, 22/7) or to spin, by the arrow keys, the wheel or the arrows at its end: an
/// exact spin box. What is typed is committed by Return, by leaving the field or after kPause, so that 1000
/// does not make trains of 1, 10 and 100 teeth on the way; Esc drops it. Text that is no such number turns
/// red and changes nothing. A decimal comma may be typed, except where the locale writes a point and the
/// comma could group thousands (1,000). Undo and redo are the document's unless something typed is not
/// committed yet.
class NumberField : public QAbstractSpinBox {
  Q_OBJECT
  // What QAccessibleAbstractSpinBox reads and sets; it asks for "stepSize", not QSpinBox's "singleStep".
  Q_PROPERTY(QVariant value READ value WRITE setValue)
  Q_PROPERTY(QVariant minimum READ minimum)
  Q_PROPERTY(QVariant maximum READ maximum)
  Q_PROPERTY(QVariant stepSize READ stepSize)

 public:
  static constexpr int kPause = 600;  ///< ms

  explicit NumberField(QWidget* parent = nullptr);

  /// Whole numbers from `least` to `most` only.
  void setWhole(int least, int most);
  /// A length in this unit of the document's: others may be typed and are converted (lengthFromText()).
  void setLengthUnit(const std::string& unit);
  void setStep(const Rational& step) { m_step = step; }
  /// What the field shows while it has no number: "auto", "several".
  void setEmptyText(const QString& text);
  /// May the field be emptied? Then edited() has no number.
  void setOptional(bool optional) { m_optional = optional; }

  /// Shows the document's number; leaves the text alone while the user types that number.
  void setNumber(const std::optional<Number>& number);
  [[nodiscard]] std::optional<Number> number() const { return m_number; }
  /// The number of edited() was not accepted: what was typed turns red, and gives way to the number of before
  /// when the field is left.
  void reject(const QString& why);
  /// Is edited() being emitted?
  [[nodiscard]] bool isCommitting() const { return m_isCommitting; }

  /// By `steps` times the step, within the bounds; from 0 where there is no number.
  void stepBy(int steps) override;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

  [[nodiscard]] QVariant value() const;
  void setValue(const QVariant& value);  ///< as if it were typed
  [[nodiscard]] QVariant minimum() const { return m_least ? QVariant(*m_least) : QVariant(); }
  [[nodiscard]] QVariant maximum() const { return m_most ? QVariant(*m_most) : QVariant(); }
  [[nodiscard]] QVariant stepSize() const { return m_step.toDouble(); }

 signals:
  void edited(const std::optional<geargraph::Number>& number);
  void wrongChanged(const QString& why);  ///< why what is typed is no such number; empty: it is one
  void editingStarted();                  ///< what follows until the next one is one gesture

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
  [[nodiscard]] QString hint() const;  ///< while nothing is wrong
  [[nodiscard]] std::optional<Number> read(const QString& text) const;
  [[nodiscard]] QSize sizeAround(const QSize& text) const;
  /// Why there is no number in this text that the field takes; empty where there is one.
  [[nodiscard]] QString objectionTo(const std::optional<Number>& number) const;
  void onText(const QString& text);
  void commit();
  void tellOf(const std::optional<Number>& number);
  void drop();
  void showNumber();
  void setWrong(const QString& why);
  void markWrong(bool isWrong);

  std::optional<Number> m_number;
  std::optional<Number> m_before;  ///< while edited() is emitted: the number until then
  QTimer m_pause;
  bool m_isPending = false;  ///< something typed is not committed
  bool m_isCommitting = false;
  Rational m_step = 1;
  std::optional<int> m_least;
  std::optional<int> m_most;
  std::optional<std::string> m_unit;  ///< of a length
  bool m_optional = false;
  bool m_selectOnRelease = false;
};

}  // namespace geargraph::inline panels
