#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <memory>

#include "core/presentation/scene/renderer.h"
#include "ui/view3d/label_layer.h"
#include "ui/view3d/picture_pace.h"
#include "ui/view3d/viewer.h"

namespace geargraph {

/// The canvas that renders the viewer's frame by OpenGL in the window.
///
/// Used only with hardware rendering, as far as that can be determined: Qt composes a window that contains a
/// QOpenGLWidget by OpenGL as a whole at every change of any part, which is slow in software.
class GlCanvas : public QOpenGLWidget {
  Q_OBJECT

 public:
  GlCanvas(Viewer* viewer, LabelLayer* labels, QWidget* parent = nullptr);
  ~GlCanvas() override;

  /// The name of the OpenGL renderer; empty before the first frame.
  [[nodiscard]] QString rendererName() const;
  [[nodiscard]] bool isSoftware() const { return m_renderer != nullptr && m_renderer->isSoftware(); }
  void setDark(bool dark) { m_dark = dark; }

 signals:
  void started();                   ///< a renderer was created: rendererName() is set
  void failed(const QString& why);  ///< no renderer could be created

 protected:
  void initializeGL() override;
  void paintGL() override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void release();
  [[nodiscard]] std::optional<Hit> pick(const Frame& frame, double x, double y);

  Viewer* m_viewer;
  LabelLayer* m_labels;
  std::unique_ptr<Renderer> m_renderer;
  PicturePace m_pace;
  bool m_sceneIsNew = true;
  bool m_dark = false;
  QElapsedTimer m_picture;  ///< since the rendering of the frame began
};

}  // namespace geargraph
