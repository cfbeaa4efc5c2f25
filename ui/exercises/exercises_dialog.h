#pragma once

#include <QDialog>

#include "core/presentation/sheet_files/sheet_files.h"
#include "ui/exercises/exercise_service.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;

namespace geargraph::inline ui_exercises {

/// Which questions are asked about the mechanism, from which seed: to be practised in a window, or written as
/// sheets and handouts for a class. Kinds that the mechanism does not give say why.
class ExercisesDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ExercisesDialog(QWidget* parent = nullptr);

  /// What is asked about from now on; what was chosen stays chosen.
  void setMechanism(const MechanismPtr& mechanism);
  /// What is asked with the kinds that are chosen; without kinds where nothing can be asked.
  [[nodiscard]] SheetPlan plan() const;
  [[nodiscard]] QListWidget& kinds() { return *m_kinds; }
  [[nodiscard]] bool isUpToDate() const { return m_service->isComplete(); }

 signals:
  void practiceWanted(const geargraph::LessonPtr& lesson);
  void sheetsWanted(const geargraph::SheetWish& wish);
  void handoutWanted(const geargraph::SheetPlan& plan);

 private:
  QWidget* makeChoice();
  QWidget* makeClass();
  void onAnswer(const ExerciseAnswer& answer);
  void showOffers(const std::vector<KindOffer>& offers);
  void practise();
  void checkAll(bool isChecked);
  void renewButtons();

  ExerciseService* m_service;
  MechanismPtr m_mechanism;
  MechanismPtr
      m_offered;  ///< whose kinds are listed: another one while those of m_mechanism are on their way
  bool m_isPractising = false;  ///< the lesson that was asked for has not come yet
  QLabel* m_difficulty;
  QListWidget* m_kinds;
  QSpinBox* m_each;
  QSpinBox* m_seed;
  QLineEdit* m_title;
  QSpinBox* m_variants;
  std::vector<std::pair<SheetFileForm, QCheckBox*>> m_forms;
  QLabel* m_count;
  QPushButton* m_practise;
  QPushButton* m_sheets;
  QPushButton* m_handout;
};

}  // namespace geargraph::inline ui_exercises
