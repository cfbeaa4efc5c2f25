#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/foundations/base/stoppable_thread.h"
#include "core/presentation/gl_renderer/egl_host.h"
#include "core/presentation/scene3d/owning_frame.h"

namespace geargraph {

/// A request for a picture.
struct PictureOrder {
  OwningFramePtr frame;
  /// The scale of the picture's sides relative to the frame, for a draft frame; in (0, 1].
  double scale = 1;
  /// The grid of the VisibilityBuffer that is wanted with it; none: no map.
  std::optional<Viewport> cells;
  /// The map may be delivered after the picture, by itself, so that the picture comes sooner; it is dropped
  /// if the next order arrives first.
  bool mapMayFollow = false;
};

/// A pick request: what is under a point of a picture?
struct PictureQuestion {
  OwningFramePtr frame;
  double x = 0;  ///< as of Renderer::pick()
  double y = 0;
  /// Dropped if a newer question of this kind is asked before its turn: for a hovering pointer only the last
  /// position matters.
  bool givesWay = false;
  std::function<void(const std::optional<Hit>& hit)> answer;  ///< called on the painting thread
};

/// The picture of an order; the image is empty if the driver was out of memory.
struct PaintedPicture {
  PictureOrder order;
  Image image;
  std::optional<VisibilityBuffer> seen;
  bool isMapAlone = false;  ///< the picture was delivered before
  double cost = 0;  ///< time that the thread spent on it, ms, including waiting for the driver's threads
};

/// Paints pictures offscreen, on a background thread, so that the window stays responsive with software
/// rendering. The newest order wins; an order replaced before its turn is dropped.
///
/// To be called from one thread at a time.
class PictureThread {
 public:
  /// Called on the painting thread with every finished picture.
  using Deliver = std::function<void(PaintedPicture picture)>;

  /// Fails with `graphics` as EglHost::create() does.
  [[nodiscard]] static Expected<std::unique_ptr<PictureThread>> start(Deliver deliver);
  /// Cancels the current picture, unless the driver has all of it already; pending orders are dropped.
  ~PictureThread();
  PictureThread(const PictureThread&) = delete;
  PictureThread& operator=(const PictureThread&) = delete;

  /// The driver's name, and whether it is software rendering.
  [[nodiscard]] const std::string& name() const { return m_name; }
  [[nodiscard]] bool isSoftware() const { return m_isSoftware; }

  /// Requests the end like the destructor, but does not wait for it.
  void requestStop() { m_thread->requestStop(); }
  /// Was the end requested, and is no work in progress?
  [[nodiscard]] bool hasStopped() const { return m_thread->hasStopped(); }

  void order(PictureOrder order);
  /// Paints these when idle, without delivering them, so that the driver compiles its shaders ahead of time.
  /// An order or a question waits for at most one of them. Those of another stage than that of the last order
  /// are dropped.
  void rehearse(std::vector<PictureOrder> orders);
  /// Blocks until all orders have been delivered, or until painting has ended.
  void finish();
  /// Questions are answered in order, before any picture that has not begun. Open questions are not answered
  /// when the thread ends.
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
  void show(const MechanismScenePtr& stage);

  Deliver m_deliver;
  std::unique_ptr<EglHost> m_host;  ///< of the painting thread
  std::stop_token m_quit;           ///< of the thread itself
  MechanismScenePtr m_stage;        ///< the stage of the host's scene; of the painting thread
  bool m_hasScene = false;
  std::string m_name;
  bool m_isSoftware = false;

  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::condition_variable m_idle;
  std::optional<PictureOrder> m_next;       ///< guarded by m_mutex
  std::deque<PictureQuestion> m_questions;  ///< guarded by m_mutex
  std::optional<PictureOrder> m_mapDue;     ///< the order whose map is pending; guarded by m_mutex
  std::deque<PictureOrder> m_rehearsals;    ///< guarded by m_mutex
  bool m_isPainting = false;                ///< guarded by m_mutex
  std::optional<StoppableThread> m_thread;  ///< last: stopped before the members it uses are destroyed
};

}  // namespace geargraph
