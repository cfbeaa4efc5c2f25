#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "core/design/teeth_search/meant_teeth.h"
#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"
#include "ui/teeth_panel/wheels_list.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QSpinBox;
class QVBoxLayout;

namespace geargraph {
class JsonWriter;
}  // namespace geargraph

namespace geargraph {

class RatioRow;

/// What is wished: ratios, the wheels that may change, and limits. It is read by readTeethWish(), as on the
/// command line, so that both know the same wishes and the same errors.
class TeethWishForm : public QWidget {
  Q_OBJECT

 public:
  explicit TeethWishForm(QWidget* parent = nullptr);

  void setMechanism(const MechanismPtr& mechanism);
  /// The keyboard to the first ratio.
  void askForRatio();
  /// Forgets the wish, for another document.
  void reset(const MechanismPtr& mechanism);
  /// The wish as JSON; a ratio without a number is 1 in it.
  [[nodiscard]] std::string wish() const;
  /// Has every ratio a number?
  [[nodiscard]] bool isWhole() const;
  /// How far the meant teeth may be from the drawn ones; none: the ratios are wanted, not stated.
  [[nodiscard]] std::optional<MeantTeethOptions> meant() const;
  void setRatiosNow(const std::vector<std::optional<Rational>>& ratios);
  [[nodiscard]] WheelsList& wheels() { return *m_wheels; }
  /// Shows what is wrong at its fields. What is about none of them is returned, as sentences.
  [[nodiscard]] QString showProblems(const Diagnostics& problems);

 public slots:
  void addRatio();

 signals:
  void edited();

 private:
  void removeRatio(RatioRow* row);
  void updateRemovable();
  void makeMeant(QVBoxLayout& layout);
  void showMeant();
  void makeLimits();
  void toDefaults();
  QLabel* addTitle(QVBoxLayout& layout, const QString& text, QWidget* atEnd);
  QSpinBox* makeSpin(const QString& name, const QString& tip, int least, int most);
  QLineEdit* makeField(const QString& name, const QString& tip);
  QCheckBox* makeCheck(const QString& name, const QString& text, const QString& tip);
  void addLimit(const QString& title, std::initializer_list<QWidget*> fields);
  void writeLimits(JsonWriter& json) const;

  MechanismPtr m_mechanism;
  std::vector<RatioRow*> m_ratios;
  int m_made = 0;  ///< rows, for their names
  QVBoxLayout* m_rows;
  QCheckBox* m_isMeant = nullptr;
  QWidget* m_near = nullptr;  ///< how near the meant teeth are
  QSpinBox* m_differing = nullptr;
  QSpinBox* m_by = nullptr;
  WheelsList* m_wheels;
  QGridLayout* m_limits;
  QSpinBox* m_fewest;
  QSpinBox* m_most;
  QSpinBox* m_mostRing;
  QSpinBox* m_planets;
  QSpinBox* m_slack;
  QComboBox* m_module;
  QLineEdit* m_stock;
  QLineEdit* m_efficiency;
  QLineEdit* m_least;
  QCheckBox* m_once;
  QCheckBox* m_keepsDistances;
  QCheckBox* m_hunting;
  QCheckBox* m_noUndercut;
  QLabel* m_problem;
};

}  // namespace geargraph
