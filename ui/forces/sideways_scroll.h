#pragma once

#include <QScrollArea>

namespace geargraph::inline forces {

/// A strip of controls that is as high as it needs and scrolls sideways where it is wider than its room, so
/// that it does not keep a panel wide.
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
