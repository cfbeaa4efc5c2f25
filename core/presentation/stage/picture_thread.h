#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/foundations/base/ending_thread.h"
#include "core/presentation/painting/egl_host.h"
#include "core/presentation/stage/kept_frame.h"

namespace geargraph::inline stage {

/// A picture that is wanted.
struct PictureOrder {
  KeptFramePtr frame;
  /// Painted with a side of this part of the frame's, for a quick look; in (0, 1].
  double scale = 1;
  /// Cells of the map of what is seen that is wanted with it.
  std::optional<Viewport> cells;
  /// The map need not come with the picture, so that this is there sooner: it is delivered after it, alone,
  /// unless the next order is there by then.
  bool mapMayFollow = false;
};

/// What is under a place of a picture?
struct PictureQuestion {
  KeptFramePtr frame;
  double x = 0;  ///< as of Renderer::pick()
  double y = 0;
  /// Dropped when a newer one that gives way too is asked before its turn: of a hovering pointer only the
  /// last place counts.
  bool givesWay = false;
  std::function<void(const std::optional<Hit>& hit)> answer;  ///< called on the painting thread
};

/// The picture of an order. An empty image where the driver had no room.
struct PaintedPicture {
  PictureOrder order;
  Image image;
  std::optional<SeenMap> seen;
  bool isMapAlone = false;  ///< the picture has been delivered before
  double cost = 0;          ///< ms that the thread has worked on it, waiting for the driver's own threads too
};

/// Paints pictures beside the screen, on a thread of its own: where the processor has to paint, the window
/// stays free for everything else. The newest order wins; one that is overtaken before its turn is dropped.
///
/// Its functions may be called from any one thread.
class PictureThread {
 public:
  /// Called on the painting thread with every picture that is finished.
  using Deliver = std::function<void(PaintedPicture picture)>;

  /// Fails with `graphics` as EglHost::create() does.
  [[nodiscard]] static Expected<std::unique_ptr<PictureThread>> start(Deliver deliver);
  /// The picture under way is given up, unless the driver has all of it already; what was ordered after it is
  /// dropped.
  ~PictureThread();
  PictureThread(const PictureThread&) = delete;
  PictureThread& operator=(const PictureThread&) = delete;

  /// What paints, and whether that is the processor.
  [[nodiscard]] const std::string& name() const { return m_name; }
  [[nodiscard]] bool isSoftware() const { return m_isSoftware; }

  /// As the destructor, but waits for nothing.
  void tellToEnd() { m_thread->tellToEnd(); }
  /// Has it been told to end, and is it no longer at work?
  [[nodiscard]] bool hasEnded() const { return m_thread->hasEnded(); }

  void order(PictureOrder order);
  /// Paints these one by one whenever there is nothing else to do, and delivers nothing: so that a driver
  /// compiles what it needs for them before somebody waits. An order or a question waits for one of them.
  /// Those of another stage than the last that was ordered are dropped.
  void rehearse(std::vector<PictureOrder> orders);
  /// Returns when all that was ordered has been delivered, or when nothing is painted any more.
  void finish();
  /// Answered in the order of the questions, and before any picture that has not been begun. Questions that
  /// are open when the thread ends are not answered.
  void ask(PictureQuestion question);

 private:
  explicit PictureThread(Deliver deliver) : m_deliver(std::move(deliver)) {}
  void run(const std::stop_token& quit, std::promise<Diagnostics> started);
  void work(const std::stop_token& quit);
  void deliver(PaintedPicture picture);
  [[nodiscard]] PaintedPicture paint(PictureOrder order);
  [[nodiscard]] PaintedPicture mapOf(PictureOrder order);
  void answer(const PictureQuestion& question);
  [[nodiscard]] bool hasWork() const {
    return m_next || !m_questions.empty() || m_mapDue || !m_rehearsals.empty();
  }
  void show(const StagePtr& stage);

  Deliver m_deliver;
  std::unique_ptr<EglHost> m_host;  ///< of the painting thread
  std::stop_token m_quit;           ///< of the thread itself
  StagePtr m_stage;                 ///< whose scene the host has; of the painting thread
  bool m_hasScene = false;
  std::string m_name;
  bool m_isSoftware = false;

  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::condition_variable m_idle;
  std::optional<PictureOrder> m_next;       ///< guarded by m_mutex
  std::deque<PictureQuestion> m_questions;  ///< guarded by m_mutex
  std::optional<PictureOrder> m_mapDue;     ///< whose map has still to follow; guarded by m_mutex
  std::deque<PictureOrder> m_rehearsals;    ///< guarded by m_mutex
  bool m_isPainting = false;                ///< guarded by m_mutex
  std::optional<EndingThread> m_thread;     ///< last: it is stopped before what it uses goes
};

}  // namespace geargraph::inline stage
