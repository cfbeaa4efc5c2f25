#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

#include "core/render/egl_host.h"
#include "ui/view3d/label_layer.h"
#include "ui/view3d/viewer.h"

namespace geargraph {

/// The viewer's picture where no window of the graphics card can be had: painted beside the screen, shown as
/// an image, with a sentence that says so. Where not even that is possible, the sentence alone.
class StillCanvas : public QWidget {
  Q_OBJECT

 public:
  StillCanvas(Viewer* viewer, LabelLayer* labels, const QString& why, QWidget* parent = nullptr);
  ~StillCanvas() override;

  [[nodiscard]] QString sentence() const { return m_sentence; }
  [[nodiscard]] bool hasPicture() const { return m_host != nullptr; }
  [[nodiscard]] QString rendererName() const;
  void setDark(bool dark) { m_dark = dark; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void paintPicture(QPainter& painter);

  Viewer* m_viewer;
  LabelLayer* m_labels;
  QString m_sentence;
  std::unique_ptr<EglHost> m_host;
  QImage m_image;
  bool m_imageIsOld = true;
  bool m_sceneIsNew = true;
  bool m_dark = false;
};

}  // namespace geargraph
