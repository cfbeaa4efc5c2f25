#pragma once

#include <QWidget>
#include <vector>

#include "core/analysis/analysis.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"

class QGridLayout;
class QLabel;

namespace geargraph {

class NumberField;
class SpeedSlider;

/// The driven joints with their speeds: a slider and a number each. A drag of a slider is one undo step.
class InputsPanel : public QWidget {
  Q_OBJECT

 public:
  InputsPanel(Document* document, Selection* selection, QWidget* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Row {
    JointId joint;
    std::vector<QWidget*> widgets;
    SpeedSlider* slider = nullptr;
    NumberField* field = nullptr;
    int range = 2;  ///< rad/s at the ends of the slider
  };

  void renew();
  void rebuild(const Mechanism& mechanism);
  Row makeRow(const Mechanism& mechanism, const Input& input, int line);
  void showSpeed(Row& row, const Number& speed);
  void setSpeed(JointId joint, const Number& speed);

  Document* m_document;
  Selection* m_selection;
  QGridLayout* m_grid;
  QLabel* m_empty;
  std::vector<Row> m_rows;
  std::vector<std::string> m_shownTitles;
  quint64 m_gesture = 0;
};

}  // namespace geargraph
