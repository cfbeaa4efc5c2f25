#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "core/foundations/base/rational.h"
#include "core/mechanism/model/mechanism.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace geargraph {
class JsonWriter;
}  // namespace geargraph

namespace geargraph {

/// One wished ratio: drive over driven, in a state, with links held or as the train is engaged, the number
/// and how far it may be missed. The tolerance is "0.5 %" of the ratio, or a number by which it may differ;
/// without one a decimal is taken as rounded.
class RatioRow : public QWidget {
  Q_OBJECT

 public:
  explicit RatioRow(int number, QWidget* parent = nullptr);

  /// Offers the links and states of a document; what is chosen stays where it is still there.
  void setMechanism(const Mechanism& mechanism);
  /// The keyboard to the field of the number.
  void askForRatio();
  /// Has a number been typed?
  [[nodiscard]] bool hasRatio() const;
  /// A member of "ratios" of a wish; of a row without a number the ratio is 1.
  void write(JsonWriter& json) const;
  void setRatioNow(const std::optional<Rational>& ratio);
  /// Says what is wrong at the field that the member of the wish comes from; an empty text clears.
  void setProblem(const QString& member, const QString& text);
  void setRemovable(bool isRemovable);

 signals:
  void edited();
  void removeWanted();

 private:
  void offer(QComboBox& box, const Mechanism& mechanism);
  void chooseUsual(const Mechanism& mechanism);
  void onCondition();
  [[nodiscard]] QLineEdit* fieldOf(const QString& member) const;

  QComboBox* m_drive;
  QComboBox* m_driven;
  QComboBox* m_condition;
  QLineEdit* m_held;
  QLineEdit* m_ratio;
  QLineEdit* m_tolerance;
  QLabel* m_now;
  QToolButton* m_remove;
  QLabel* m_problem;
};

/// What is typed as JSON reads it: with a decimal point, ASCII signs, without blanks at its ends.
[[nodiscard]] std::string plainNumber(const QString& typed);
/// Paints a field's text as wrong, or as usual again.
void markField(QLineEdit& field, bool isWrong);

}  // namespace geargraph
