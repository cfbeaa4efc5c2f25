#pragma once

#include <QWidget>
#include <vector>

#include "core/theory/analysis/analysis.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"

class QGridLayout;
class QLabel;
class QMenu;
class QToolButton;

namespace geargraph {

class NumberField;
class RateLabel;
class SpeedSlider;

/// The input joints with a slider and a number for each speed. A drag of a slider is one undo step. Each
/// input can be exchanged for any joint that keeps the set of inputs valid; the motion stays the same.
class InputsPanel : public QWidget {
  Q_OBJECT

 public:
  InputsPanel(Document* document, Selection* selection, QWidget* parent = nullptr);

  void setSnapshot(const SnapshotPtr& snapshot);

 public slots:
  /// Makes these joints (ordinals of the snapshot's digraph) the inputs, at their current speeds.
  void drive(const std::vector<int>& joints);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Row {
    JointId joint;
    std::vector<QWidget*> widgets;
    QLabel* dot = nullptr;
    RateLabel* name = nullptr;
    SpeedSlider* slider = nullptr;
    NumberField* field = nullptr;
    QLabel* unit = nullptr;
    QToolButton* exchange = nullptr;
    int range = 2;  ///< rad/s, of what slides lengths a second, at the ends of the slider
  };

  void startAnew();
  void renew();
  /// From the first on.
  void removeRows(std::size_t first);
  Row makeRow(const Input& input, int line);
  /// "8 4 sun 0 ground": the labels of the joint and of the links that it joins, with their names; the unit
  /// of its speed.
  [[nodiscard]] std::string titleOf(JointId joint) const;
  void showTitle(const Row& row);
  void showSpeed(Row& row, const Number& speed);
  void setSpeed(JointId joint, const Number& speed);
  QToolButton* makeExchange(JointId joint);
  void fillExchange(QMenu& menu, JointId input);
  void updateEmptyText();
  void updateChoice();
  void updateEngaged();

  Document* m_document;
  Selection* m_selection;
  QLabel* m_engaged;  ///< names of engaged couplings
  QToolButton* m_release;
  QWidget* m_list;  ///< of rows
  QGridLayout* m_grid;
  QLabel* m_empty;
  QToolButton* m_more;
  QToolButton* m_choose;
  SnapshotPtr m_snapshot;
  std::vector<Row> m_rows;  ///< of the first inputs
  std::vector<std::string> m_shownTitles;
  std::size_t m_mostRows;  ///< shown; "more" shows the others
  quint64 m_gesture = 0;
};

}  // namespace geargraph
