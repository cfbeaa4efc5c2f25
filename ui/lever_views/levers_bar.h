#pragma once

#include <QWidget>

#include "ui/lever_views/levers_service.h"

class QButtonGroup;
class QCheckBox;

namespace geargraph {

/// The row above the drawing: which drawing is shown, and which arrows.
class LeversBar final : public QWidget {
  Q_OBJECT

 public:
  explicit LeversBar(QWidget* parent = nullptr);

  [[nodiscard]] LeversPage page() const;
  /// As if its button were clicked.
  void setPage(LeversPage page);
  [[nodiscard]] bool showsSpeeds() const;
  [[nodiscard]] bool showsTorques() const;

 signals:
  void pageChosen(geargraph::LeversPage page);
  void arrowsChosen();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QButtonGroup* m_pages;
  QWidget* m_arrows;
  QCheckBox* m_speeds;
  QCheckBox* m_torques;
};

}  // namespace geargraph
