#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <memory>

#include "core/presentation/painting/renderer.h"
#include "ui/view3d/label_layer.h"
#include "ui/view3d/picture_pace.h"
#include "ui/view3d/viewer.h"

namespace geargraph::inline view3d {

/// The viewer's picture by the graphics card, in its window.
///
/// For a real card only, as far as that can be known: a window with a QOpenGLWidget in it is uploaded and put
/// together by OpenGL as a whole at every change of any part of it, and a processor is slow at that.
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

 private:
  void release();
  [[nodiscard]] std::optional<Hit> pick(const Frame& frame, double x, double y);

  Viewer* m_viewer;
  LabelLayer* m_labels;
  std::unique_ptr<Renderer> m_renderer;
  PicturePace m_pace;
  bool m_sceneIsNew = true;
  bool m_dark = false;
  QElapsedTimer m_picture;  ///< since its painting began
};

}  // namespace geargraph::inline view3d
