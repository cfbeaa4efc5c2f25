#pragma once

#include <QObject>
#include <QRect>

namespace geargraph::inline mainwindow {

/// Where a window goes that wants `wanted`, without its frame: no larger than `room` and inside of it.
[[nodiscard]] QRect fittedInto(const QRect& room, const QRect& wanted);

/// While it lives, windows and dialogs of the program open no larger than the screen, also at scale factors
/// that leave few logical pixels and with a geometry that was saved on a larger screen. Where the contents
/// need more than the screen has, they are clipped, not the window.
class ScreenFit : public QObject {
  Q_OBJECT

 public:
  explicit ScreenFit(QObject* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace geargraph::inline mainwindow
