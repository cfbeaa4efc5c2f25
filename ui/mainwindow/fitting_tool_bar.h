#pragma once

#include <QToolBar>

namespace geargraph {

/// A tool bar whose buttons show their names where all fit, otherwise their icons only, so that none goes
/// into the menu at its end.
class FittingToolBar : public QToolBar {
  Q_OBJECT

 public:
  using QToolBar::QToolBar;

  /// Adds a button that may lose its name.
  void addNamed(QAction* action);
  [[nodiscard]] bool areNamesShown() const { return m_areNamesShown; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void fit();
  void showNames(bool shown);

  QList<QAction*> m_named;
  bool m_areNamesShown = true;
};

}  // namespace geargraph
