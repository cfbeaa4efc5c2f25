#pragma once

#include <QScrollArea>

namespace geargraph::inline forces {

/// A strip of controls with its natural height that scrolls horizontally if it is too wide, so that it does
/// not force a minimum width on a panel.
class SidewaysScroll : public QScrollArea {
  Q_OBJECT

 public:
  explicit SidewaysScroll(QWidget* strip, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 private:
  [[nodiscard]] int wantedHeight() const;
};

}  // namespace geargraph::inline forces
