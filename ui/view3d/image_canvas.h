#pragma once

#include <QImage>
#include <QWidget>
#include <memory>
#include <mutex>

#include "core/presentation/stage/picture_thread.h"
#include "ui/service/background_work.h"
#include "ui/view3d/label_layer.h"
#include "ui/view3d/look_level.h"
#include "ui/view3d/picture_pace.h"
#include "ui/view3d/viewer.h"

namespace geargraph::inline view3d {

/// The viewer's picture where the processor has to paint, or where no window of the graphics card can be had:
/// painted beside the screen, on a thread of its own, and shown as an image. So the window waits for nothing,
/// and is not put together by OpenGL at every change of any part of it.
///
/// The newest picture that is finished is on the screen; what is grabbed waits for the picture of the moment.
class ImageCanvas : public QWidget, public BackgroundWork {
  Q_OBJECT

 public:
  ImageCanvas(Viewer* viewer, LabelLayer* labels, QWidget* parent = nullptr);
  ~ImageCanvas() override;

  /// Why nothing can be painted; empty where something can.
  [[nodiscard]] QString problem() const { return m_problem; }
  /// What paints; empty where nothing does.
  [[nodiscard]] QString rendererName() const;
  [[nodiscard]] bool isSoftware() const { return m_thread != nullptr && m_thread->isSoftware(); }
  void setDark(bool dark) { m_dark = dark; }
  /// Shown while there are bodies, but no picture of any yet.
  void setWaitingText(const QString& text) { m_waitingText = text; }
  void tellToEnd() override;
  [[nodiscard]] bool hasEnded() const override { return m_thread == nullptr || m_thread->hasEnded(); }
  /// Is the picture of the moment on the screen?
  [[nodiscard]] bool isUpToDate() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Shown {
    KeptFramePtr frame;
    QImage image;  ///< in the screen's own format
    double cost = 0;
  };
  struct Map {
    SeenMap seen;
    std::size_t parts = 0;  ///< instances of its stage
  };

  /// Orders the picture of the moment once the event that changes it is over.
  void orderSoon();
  void order(bool quick);
  void rehearse();
  void deliver(PaintedPicture picture);  ///< on the painting thread
  void takeUp();
  [[nodiscard]] bool isOnScreen(const QPainter& painter) const;
  void paintGround(QPainter& painter) const;
  void addOverlay();
  [[nodiscard]] bool isWaiting() const;
  void paintWords(QPainter& painter, const QString& text) const;
  /// Answered when the picture under way is finished.
  void pick(const Frame& frame, double x, double y, Viewer::PickFor use, Viewer::Answer answer);

  Viewer* m_viewer;
  LabelLayer* m_labels;
  PicturePace m_pace;
  QString m_problem;
  QString m_waitingText;
  bool m_dark = false;
  bool m_willOrder = false;
  bool m_owesMap = false;    ///< a map that is due has not come yet: its picture may have been overtaken
  bool m_isPainted = false;  ///< what is shown is on the screen
  bool m_isStep = false;     ///< the last quick look that was ordered is the first of its stage
  LookLevel m_look;
  bool m_hasRehearsed = false;
  KeptFramePtr m_ordered;
  KeptFramePtr m_quick;      ///< the last quick look that was ordered
  Shown m_shown;             ///< labels and scale bar are in the image once it is painted
  std::optional<Map> m_map;  ///< that labels have not been placed by yet
  std::mutex m_mutex;
  std::optional<Shown> m_delivered;         ///< guarded by m_mutex
  std::optional<Map> m_deliveredMap;        ///< guarded by m_mutex
  std::unique_ptr<PictureThread> m_thread;  ///< last: it is stopped before what it uses goes
};

}  // namespace geargraph::inline view3d
