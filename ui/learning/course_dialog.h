#pragma once

#include <QDialog>

#include "core/teaching/lessons/lesson.h"

class QLabel;
class QListView;
class QPushButton;
class QStandardItemModel;

namespace geargraph {

/// The bundled lessons with their goals, durations and the learner's progress. A double click, or Return,
/// starts, continues or reviews one.
class CourseDialog : public QDialog {
  Q_OBJECT

 public:
  explicit CourseDialog(QWidget* parent = nullptr);

  /// Reloads the progress.
  void renew();
  [[nodiscard]] QListView& list() { return *m_list; }

 signals:
  void lessonChosen(int lesson);  ///< by its position in the course
  void testWanted();              ///< that tells where to begin
  void fileWanted();

 private:
  void choose(int lesson);
  void updateButton();

  QStandardItemModel* m_model;
  QListView* m_list;
  QLabel* m_summary;
  QPushButton* m_start;
};

}  // namespace geargraph
