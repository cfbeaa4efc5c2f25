#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace geargraph {

class GlCanvas;
class ImageCanvas;
class LabelLayer;
class Viewer;

/// Makes the canvas of a 3D view, behind the other children of `view` and in its layout: an OpenGL window or
/// an image (canvasSurface()), and the other one where the first turns out to be impossible.
class CanvasHost : public QObject {
  Q_OBJECT

 public:
  CanvasHost(Viewer* viewer, LabelLayer* labels, QWidget* view);

  /// Makes the canvas, which shows `waiting` while there are bodies but no frame yet. @pre the view has a
  /// layout
  void start(const QString& waiting);
  /// Deletes the canvas, which needs the viewer.
  void stop();
  [[nodiscard]] QWidget* canvas() const;
  void setDark(bool dark);
  /// The renderer's name according to the driver; empty before the first frame, or if there is no renderer.
  [[nodiscard]] QString rendererName() const;
  [[nodiscard]] bool isImage() const { return m_gl == nullptr; }
  /// Is the current frame shown? Images are rendered in the background.
  [[nodiscard]] bool isUpToDate() const;

 signals:
  /// A renderer was created. `why` there is no OpenGL window; empty if one would be possible.
  void started(bool isSoftware, const QString& why);

 private:
  void place(QWidget* canvas);
  void useGl();
  void useImage(const QString& why);

  Viewer* m_viewer;
  LabelLayer* m_labels;
  QWidget* m_view;
  QString m_waiting;
  GlCanvas* m_gl = nullptr;
  ImageCanvas* m_image = nullptr;
  bool m_isDark = false;
};

}  // namespace geargraph
