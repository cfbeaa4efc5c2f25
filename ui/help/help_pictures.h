#pragma once

#include <QHash>
#include <QImage>
#include <QObject>
#include <QSize>
#include <QThreadPool>

#include "core/presentation/drawing/palette.h"

namespace geargraph {

/// The pictures of the manual: drawings are made on a background thread when a page first shows them,
/// screenshots are read from the folder that the build has filled.
class HelpPictures : public QObject {
  Q_OBJECT

 public:
  explicit HelpPictures(QObject* parent = nullptr);
  /// Waits for the current drawing, at most some hundred milliseconds.
  ~HelpPictures() override;

  /// The size of all drawings, so that a page keeps its layout when one arrives. `width`: the available
  /// width.
  [[nodiscard]] static QSize drawingSize(int width);

  /// A drawing such as "digraph/robot/link.4" on a transparent background; fully transparent until it is
  /// made, then drawn() follows.
  [[nodiscard]] QImage drawing(const QString& name, Theme theme, QSize size, double pixelRatio);
  /// The screenshot "robot", as wide as fits; null if the build has none.
  [[nodiscard]] static QImage ofWindow(const QString& name, Theme theme, int width, double pixelRatio);
  [[nodiscard]] bool isSettled() const { return m_underWay == 0; }

 signals:
  void drawn(const QString& name);

 private:
  void keep(const QString& key, const QString& name, const QImage& picture);

  QThreadPool m_pool;  ///< one thread, so that pictures are made from the top of the page
  QHash<QString, QImage> m_made;
  int m_underWay = 0;
};

}  // namespace geargraph
