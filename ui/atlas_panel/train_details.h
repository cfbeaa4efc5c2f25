#pragma once

#include <QWidget>
#include <map>
#include <set>

#include "core/mechanism/model/mechanism.h"
#include "ui/atlas_panel/train_choices.h"

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace geargraph {

class ChainPicture;

/// What can be asked about the train beside its number: the trees of turning joints, inputs and frames with
/// which it can be drawn, and whether it is the same chain as that of another document, link by link. Rows
/// light up what they name in the train's drawings.
class TrainDetails final : public QWidget {
  Q_OBJECT

 public:
  explicit TrainDetails(QWidget* parent = nullptr);

  /// Null, or one that is unfinished: nothing can be asked. What was asked of the last train is asked again.
  void setTrain(const TrainAnswerPtr& train);
  void setChoices(const TrainChoicesPtr& choices);
  void setComparison(const TrainComparisonPtr& comparison);
  /// Asks for a comparison with the document in this file.
  void compareWith(const QString& path);

 signals:
  void choicesWanted();
  void comparisonWanted(const QString& path);
  void showWanted(const std::set<geargraph::ElementId>& elements);

 private:
  [[nodiscard]] bool isIdentified() const;
  [[nodiscard]] QTreeWidget* makeList(const QString& name, const QString& title, int columns);
  void chooseOther();
  void showOne(const QTreeWidgetItem* item);
  /// A row without elements lights up nothing.
  QTreeWidgetItem* addRow(QTreeWidget& list, QTreeWidgetItem* above, const QStringList& texts,
                          std::set<ElementId> elements = {});
  void clearRows(QTreeWidget& list);
  void fillPairs(const QString& title, const std::vector<std::vector<TurningPair>>& sets, bool areAll);
  void fillMatch(const TrainComparison& comparison);
  void showPictures(const TrainComparison& comparison);

  TrainAnswerPtr m_train;
  std::map<const QTreeWidgetItem*, std::set<ElementId>> m_elements;  ///< by row
  QString m_path;  ///< of the document that it is compared with; empty: none
  QPushButton* m_ask;
  QTreeWidget* m_choices;
  QPushButton* m_compare;
  QLabel* m_verdict;
  ChainPicture* m_own;
  ChainPicture* m_other;
  QTreeWidget* m_match;
};

}  // namespace geargraph
