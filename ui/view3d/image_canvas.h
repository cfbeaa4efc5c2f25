#pragma once

#include <QImage>
#include <QWidget>
#include <memory>
#include <mutex>

#include "core/presentation/mechanism_scene/picture_thread.h"
#include "ui/service/background_work.h"
#include "ui/view3d/draft_level.h"
#include "ui/view3d/label_layer.h"
#include "ui/view3d/picture_pace.h"
#include "ui/view3d/viewer.h"

namespace geargraph {

/// The canvas for software rendering, or where no OpenGL window is available: the viewer's frame is rendered
/// offscreen on a background thread and shown as an image. So the window stays responsive, and OpenGL does
/// not compose it at every change of any part.
///
/// The last finished frame is shown; grabbing the widget waits for the current one.
class ImageCanvas : public QWidget, public BackgroundWork {
  Q_OBJECT

 public:
  ImageCanvas(Viewer* viewer, LabelLayer* labels, QWidget* parent = nullptr);
  ~ImageCanvas() override;

  /// Why rendering is impossible; empty if it is possible.
  [[nodiscard]] QString problem() const { return m_problem; }
  /// The name of the OpenGL renderer; empty if there is none.
  [[nodiscard]] QString rendererName() const;
  [[nodiscard]] bool isSoftware() const { return m_thread != nullptr && m_thread->isSoftware(); }
  void setDark(bool dark) { m_dark = dark; }
  /// Sets the text shown while there are bodies but no frame yet.
  void setWaitingText(const QString& text) { m_waitingText = text; }
  void requestStop() override;
  [[nodiscard]] bool hasStopped() const override { return m_thread == nullptr || m_thread->hasStopped(); }
  /// Is the current frame shown?
  [[nodiscard]] bool isUpToDate() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Shown {
    OwningFramePtr frame;
    QImage image;  ///< in the format of the screen
    double cost = 0;
  };
  struct Map {
    VisibilityBuffer seen;
    std::size_t parts = 0;  ///< instances of its stage
  };

  /// Requests the current frame after the event being handled.
  void orderSoon();
  void order(bool draft);
  void rehearse();
  void deliver(PaintedPicture picture);  ///< on the rendering thread
  void takeUp();
  [[nodiscard]] bool isOnScreen(const QPainter& painter) const;
  void paintGround(QPainter& painter) const;
  void addOverlay();
  [[nodiscard]] bool isWaiting() const;
  void paintWords(QPainter& painter, const QString& text) const;
  /// Answered when the frame being rendered is finished.
  void pick(const Frame& frame, double x, double y, Viewer::PickFor use, Viewer::Answer answer);

  Viewer* m_viewer;
  LabelLayer* m_labels;
  PicturePace m_pace;
  QString m_problem;
  QString m_waitingText;
  bool m_dark = false;
  bool m_willOrder = false;
  bool m_owesMap = false;    ///< a requested map has not arrived: its frame may be superseded
  bool m_isPainted = false;  ///< m_shown has been painted
  bool m_isStep = false;     ///< the last requested draft frame is the first of its stage
  DraftLevel m_draftLevel;
  bool m_hasRehearsed = false;
  OwningFramePtr m_ordered;
  OwningFramePtr m_draft;    ///< the last requested draft frame
  Shown m_shown;             ///< includes labels and scale bar once painted
  std::optional<Map> m_map;  ///< not yet used to place labels
  std::mutex m_mutex;
  std::optional<Shown> m_delivered;         ///< guarded by m_mutex
  std::optional<Map> m_deliveredMap;        ///< guarded by m_mutex
  std::unique_ptr<PictureThread> m_thread;  ///< last: stopped before the members it uses are destroyed
};

}  // namespace geargraph
