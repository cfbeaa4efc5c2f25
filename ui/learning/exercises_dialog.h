#pragma once

#include <QDialog>

#include "core/presentation/exercise_sheets/sheet_files.h"
#include "ui/learning/exercise_service.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;

namespace geargraph {

/// Chooses questions about the mechanism and their seed: to be practised in a window, or written as sheets
/// and handouts for a class. Kinds that are not available show the reason.
class ExercisesDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ExercisesDialog(QWidget* parent = nullptr);

  /// Sets the mechanism; the choices are kept.
  void setMechanism(const MechanismPtr& mechanism);
  /// The plan with the chosen kinds; without kinds if none is available.
  [[nodiscard]] SheetPlan plan() const;
  [[nodiscard]] QListWidget& kinds() { return *m_kinds; }
  [[nodiscard]] bool isUpToDate() const { return m_service->isComplete(); }

 signals:
  void practiceWanted(const geargraph::LessonPtr& lesson);
  void sheetsWanted(const geargraph::SheetRequest& request);
  void handoutWanted(const geargraph::SheetPlan& plan);

 private:
  QWidget* makeChoice();
  QWidget* makeClass();
  void onAnswer(const ExerciseAnswer& answer);
  void showOffers(const std::vector<KindOffer>& offers);
  void practise();
  void checkAll(bool isChecked);
  void updateButtons();

  ExerciseService* m_service;
  MechanismPtr m_mechanism;
  MechanismPtr m_offered;       ///< whose kinds are listed: the former one until those of m_mechanism arrive
  bool m_isPractising = false;  ///< waiting for the requested lesson
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

}  // namespace geargraph
