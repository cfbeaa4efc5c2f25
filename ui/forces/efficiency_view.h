#pragma once

#include <QWidget>

#include "ui/document/document.h"
#include "ui/workbench/forces_service.h"

class QBoxLayout;
class QScrollArea;

namespace geargraph {

class EfficiencyCard;
class EfficiencyPage;

/// The efficiency of the train as numbers, with what the meshes state, and beside them as a plot; below them
/// where the view is narrow.
class EfficiencyView : public QWidget {
  Q_OBJECT

 public:
  explicit EfficiencyView(Document* document, QWidget* parent = nullptr);

  void show(const ForcesPtr& forces);
  [[nodiscard]] bool isUpToDate() const;
  [[nodiscard]] EfficiencyCard& card() { return *m_card; }
  [[nodiscard]] EfficiencyPage& plots() { return *m_plots; }
  [[nodiscard]] const EfficiencyPage& plots() const { return *m_plots; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void arrange();

  EfficiencyCard* m_card;
  EfficiencyPage* m_plots;
  QScrollArea* m_cardView;
  QBoxLayout* m_layout;
};

}  // namespace geargraph
