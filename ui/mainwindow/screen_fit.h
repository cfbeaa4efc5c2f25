#pragma once

#include <QObject>
#include <QRect>

namespace geargraph {

/// The rectangle `wanted` of a window (without its frame), reduced and moved to fit into `room`.
[[nodiscard]] QRect fittedInto(const QRect& room, const QRect& wanted);

/// While it exists, windows and dialogs open no larger than the screen, also at scale factors with few
/// logical pixels and with a geometry saved on a larger screen. If the contents need more space than the
/// screen has, they are clipped, not the window.
class ScreenFit : public QObject {
  Q_OBJECT

 public:
  explicit ScreenFit(QObject* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace geargraph
