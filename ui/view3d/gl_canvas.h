#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>
#include <memory>

#include "core/render/renderer.h"
#include "ui/view3d/label_layer.h"
#include "ui/view3d/viewer.h"

namespace geargraph {

/// The viewer's picture by the graphics card, in its window. Where the processor has to paint, antialiasing
/// and shadow come as soon as the picture stands still.
class GlCanvas : public QOpenGLWidget {
  Q_OBJECT

 public:
  GlCanvas(Viewer* viewer, LabelLayer* labels, QWidget* parent = nullptr);
  ~GlCanvas() override;

  /// What paints, once something was painted; empty before.
  [[nodiscard]] QString rendererName() const;
  [[nodiscard]] bool isSoftware() const { return m_renderer != nullptr && m_renderer->isSoftware(); }
  void setDark(bool dark) { m_dark = dark; }

 signals:
  void started();                   ///< a renderer is at work: rendererName() tells which
  void failed(const QString& why);  ///< no renderer could be made

 protected:
  void initializeGL() override;
  void paintGL() override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void release();
  void onMoving();
  /// A map of the picture for the labels, where it is time for one.
  [[nodiscard]] std::optional<SeenMap> seenNow();
  [[nodiscard]] std::optional<Hit> pick(const Frame& frame, double x, double y);

  Viewer* m_viewer;
  LabelLayer* m_labels;
  std::unique_ptr<Renderer> m_renderer;
  bool m_sceneIsNew = true;
  bool m_dark = false;
  bool m_still = true;  ///< nothing has changed for a while: the picture may cost more
  QTimer m_whenStill;
  bool m_mapIsOld = false;  ///< labels stand by an earlier picture's map
  QElapsedTimer m_sinceMap;
  QElapsedTimer m_sinceScene;
  QElapsedTimer m_picture;  ///< since its painting began
};

}  // namespace geargraph
