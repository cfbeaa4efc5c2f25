#include "core/presentation/mechanism_scene/picture_thread.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

namespace geargraph {
namespace {

Frame stoppable(Frame frame, const std::stop_token& stop) {
  frame.stop = stop;
  return frame;
}

/// The same picture with fewer pixels: lines and letters keep their part of it.
Frame scaled(Frame smaller, double scale) {
  const Viewport whole = smaller.viewport;
  smaller.viewport.width = std::max(1, static_cast<int>(std::lround(scale * whole.width)));
  smaller.viewport.height = std::max(1, static_cast<int>(std::lround(scale * whole.height)));
  smaller.pixelRatio *= scale;
  return smaller;
}

}  // namespace

Expected<std::unique_ptr<PictureThread>> PictureThread::start(Deliver deliver) {
  std::unique_ptr<PictureThread> made(new PictureThread(std::move(deliver)));
  std::promise<Diagnostics> started;
  std::future<Diagnostics> outcome = started.get_future();
  made->m_thread.emplace([self = made.get(), started = std::move(started)](
                             const std::stop_token& quit) mutable { self->run(quit, std::move(started)); });
  if (Diagnostics problems = outcome.get(); !problems.empty()) return problems;
  return made;
}

PictureThread::~PictureThread() = default;

// A context belongs to one thread: the host is made and goes here.
void PictureThread::run(const std::stop_token& quit, std::promise<Diagnostics> started) {
  auto host = EglHost::create();
  if (!host) return started.set_value(host.error());
  m_host = std::move(host).value();
  m_name = m_host->name();
  m_isSoftware = m_host->isSoftware();
  m_quit = quit;
  started.set_value({});
  work(quit);
  m_host.reset();
  const std::lock_guard lock(m_mutex);
  m_idle.notify_all();
}

// A question goes before pictures, what is ordered before what may follow, and that before rehearsals.
void PictureThread::work(const std::stop_token& quit) {
  while (true) {
    std::unique_lock lock(m_mutex);
    m_isPainting = false;
    if (!m_next && !m_mapDue) m_idle.notify_all();
    m_wake.wait(lock, quit, [this] { return hasWork(); });
    if (quit.stop_requested()) return;
    if (!m_questions.empty()) {
      const PictureQuestion question = std::move(m_questions.front());
      m_questions.pop_front();
      lock.unlock();
      answer(question);
      continue;
    }
    std::optional<PictureOrder> due = std::exchange(m_mapDue, std::nullopt);
    m_isPainting = m_next || due;
    if (m_next) {
      PictureOrder order = *std::exchange(m_next, std::nullopt);
      if (order.cells && order.mapMayFollow) m_mapDue = order;
      lock.unlock();
      deliver(paint(std::move(order)));
    } else if (due) {
      lock.unlock();
      deliver(mapOf(*std::move(due)));
    } else {
      const PictureOrder rehearsal = std::move(m_rehearsals.front());
      m_rehearsals.pop_front();
      lock.unlock();
      if (rehearsal.frame->stage() == m_stage) static_cast<void>(paint(rehearsal));
    }
  }
}

void PictureThread::deliver(PaintedPicture picture) {
  if (!m_quit.stop_requested()) m_deliver(std::move(picture));
}

void PictureThread::answer(const PictureQuestion& question) {
  show(question.frame->stage());
  question.answer(m_host->pick(question.frame->frame(), question.x, question.y));
}

void PictureThread::show(const MechanismScenePtr& stage) {
  if (m_hasScene && stage == m_stage) return;
  m_host->setScene(stage ? stage->scene : Scene{});
  m_stage = stage;
  m_hasScene = true;
}

PaintedPicture PictureThread::paint(PictureOrder order) {
  const auto begin = std::chrono::steady_clock::now();
  show(order.frame->stage());
  PaintedPicture picture;
  picture.image = m_host->picture(scaled(stoppable(order.frame->frame(), m_quit), order.scale));
  if (order.cells && !order.mapMayFollow) picture.seen = mapOf(order).seen;
  picture.order = std::move(order);
  picture.cost = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return picture;
}

PaintedPicture PictureThread::mapOf(PictureOrder order) {
  show(order.frame->stage());
  PaintedPicture map;
  map.seen = m_host->seen(stoppable(order.frame->frame(), m_quit), order.cells->width, order.cells->height);
  map.order = std::move(order);
  map.isMapAlone = true;
  return map;
}

void PictureThread::order(PictureOrder order) {
  {
    const std::lock_guard lock(m_mutex);
    m_next = std::move(order);
  }
  m_wake.notify_one();
}

void PictureThread::finish() {
  std::unique_lock lock(m_mutex);
  m_idle.wait(lock, [this] { return m_quit.stop_requested() || (!m_next && !m_mapDue && !m_isPainting); });
}

void PictureThread::rehearse(std::vector<PictureOrder> orders) {
  {
    const std::lock_guard lock(m_mutex);
    m_rehearsals.insert(m_rehearsals.end(), std::make_move_iterator(orders.begin()),
                        std::make_move_iterator(orders.end()));
  }
  m_wake.notify_one();
}

void PictureThread::ask(PictureQuestion question) {
  {
    const std::lock_guard lock(m_mutex);
    const auto givesWay = [](const PictureQuestion& open) { return open.givesWay; };
    if (question.givesWay) std::erase_if(m_questions, givesWay);
    m_questions.push_back(std::move(question));
  }
  m_wake.notify_one();
}

}  // namespace geargraph
