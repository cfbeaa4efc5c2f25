#pragma once

#include <QHash>
#include <QImage>
#include <QObject>
#include <QSize>
#include <QThreadPool>

#include "core/presentation/drawing/palette.h"

namespace geargraph::inline ui_help {

/// The pictures of the manual: drawings are made beside the window when a page first shows them, pictures of
/// the window are read from the folder that the build has filled.
class HelpPictures : public QObject {
  Q_OBJECT

 public:
  explicit HelpPictures(QObject* parent = nullptr);
  /// Waits for the drawing that is under way, some hundred milliseconds at most.
  ~HelpPictures() override;

  /// Every drawing has this size, so that a page keeps its layout when one comes. `width`: what there is.
  [[nodiscard]] static QSize drawingSize(int width);

  /// "digraph/robot/link.4" on a clear ground; clear as long as it is not made, then drawn() follows.
  [[nodiscard]] QImage drawing(const QString& name, Theme theme, QSize size, double pixelRatio);
  /// "robot", as wide as it fits; null where the build took none.
  [[nodiscard]] static QImage ofWindow(const QString& name, Theme theme, int width, double pixelRatio);
  [[nodiscard]] bool isSettled() const { return m_underWay == 0; }

 signals:
  void drawn(const QString& name);

 private:
  void keep(const QString& key, const QString& name, const QImage& picture);

  QThreadPool m_pool;  ///< one thread: the page is read from its top
  QHash<QString, QImage> m_made;
  int m_underWay = 0;
};

}  // namespace geargraph::inline ui_help
