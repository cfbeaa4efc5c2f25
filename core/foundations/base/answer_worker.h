#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include "core/foundations/base/request_worker.h"
#include "core/foundations/base/translation.h"

namespace geargraph {

/// What happens to answers to a request that a newer one has replaced.
enum class Superseded {
  dropped,   ///< its work is asked to stop, and no more answers to it are delivered
  delivered  ///< answers that its work still produces are delivered: pictures during a drag, if late
};

/// One answer to a request, or the reason why there is none.
template <class Answer>
struct Reply {
  std::uint64_t number = 0;      ///< of the request, from AnswerWorker::request()
  bool isLast = true;            ///< no more answers to this request follow
  std::optional<Answer> answer;  ///< none if the work failed
  std::string failure;           ///< the reason; empty on success
};

/// Answers requests on a background thread; the newest request wins. A request is answered once, or by
/// partial answers that replace each other, or not at all if it is replaced by a newer one or cancelled.
///
/// The destructor asks the current work to stop and waits for it; nothing is delivered afterwards. Free of
/// Qt, as RequestWorker is.
template <class Request, class Answer>
class AnswerWorker {
 public:
  /// Called on the thread that made the reply, never concurrently.
  using Deliver = std::function<void(const Reply<Answer>& reply)>;

  /// Receives the answers to one request. Thread-safe and copyable; valid as long as the worker exists.
  class Responder {
   public:
    /// Delivers the complete answer.
    void operator()(Answer answer) const {
      m_worker->deliver(*this, {m_number, true, std::move(answer), {}});
    }
    /// Delivers a partial answer; another one follows.
    void partly(Answer answer) const { m_worker->deliver(*this, {m_number, false, std::move(answer), {}}); }
    /// Runs a part of the work; an exception is delivered as the last reply, with its text as the failure.
    /// Lack of memory is reported in the current language.
    template <class Part>
    void guard(const Part& part) const {
      try {
        part();
      } catch (const std::bad_alloc&) {
        fail(translated("there is not enough memory"));
      } catch (const std::exception& error) {
        fail(error.what());
      }
    }
    /// Requested when the answer is no longer wanted.
    [[nodiscard]] const std::stop_token& stop() const { return m_stop; }

   private:
    friend class AnswerWorker;
    void fail(std::string why) const {
      m_worker->deliver(*this, {m_number, true, std::nullopt, std::move(why)});
    }
    Responder(AnswerWorker* worker, std::uint64_t number, std::stop_token stop)
        : m_worker(worker), m_number(number), m_stop(std::move(stop)) {}

    AnswerWorker* m_worker;
    std::uint64_t m_number;
    std::stop_token m_stop;
  };

  /// Called on the worker's thread, for one request at a time, within guard(). It may answer later from
  /// threads of its own.
  using Work = std::function<void(const Request& request, const Responder& respond)>;

  AnswerWorker(Work work, Deliver deliver, Urgency urgency = Urgency::prompt,
               Superseded superseded = Superseded::dropped)
      : m_deliver(std::move(deliver)),
        m_superseded(superseded),
        m_worker(
            [this, work = std::move(work)](const Numbered& next, const std::stop_token& stop) {
              const Responder respond(this, next.number, stop);
              respond.guard([&] { work(next.request, respond); });
            },
            urgency) {}

  /// Adds a request and returns its number, one more than that of the request before. Thread-safe.
  std::uint64_t request(Request request) {
    const std::lock_guard lock(m_asking);
    m_worker.request({std::move(request), ++m_newest});
    return m_newest;
  }

  /// Cancels all requests so far: none of their replies is delivered afterwards, except one being delivered
  /// already. Thread-safe.
  void cancel() {
    const std::lock_guard lock(m_asking);
    m_cancelled = m_newest;  // first: work that sees the stop may answer at once
    m_worker.cancel();
  }

  /// As for RequestWorker.
  void requestStop() { m_worker.requestStop(); }
  [[nodiscard]] bool hasStopped() const { return m_worker.hasStopped(); }

  /// Blocks until the last reply to a request has been delivered, and returns it; std::nullopt after `most`,
  /// or if the request was replaced.
  [[nodiscard]] std::optional<Reply<Answer>> await(std::uint64_t number, std::chrono::milliseconds most) {
    std::unique_lock lock(m_delivering);
    m_answered.wait_for(lock, most, [&] { return m_last && m_last->number >= number; });
    return m_last && m_last->number == number ? m_last : std::nullopt;
  }

 private:
  struct Numbered {
    Request request;
    std::uint64_t number = 0;
  };

  void deliver(const Responder& from, Reply<Answer> reply) {
    const std::lock_guard lock(m_delivering);
    if (m_superseded == Superseded::dropped && from.m_stop.stop_requested()) return;
    if (reply.number <= m_cancelled) return;
    m_deliver(reply);
    if (!reply.isLast) return;
    m_last = std::move(reply);
    m_answered.notify_all();
  }

  Deliver m_deliver;
  Superseded m_superseded;
  std::mutex m_asking;
  std::uint64_t m_newest = 0;                  ///< guarded by m_asking
  std::atomic<std::uint64_t> m_cancelled = 0;  ///< requests up to this one are no longer answered
  std::mutex m_delivering;
  std::condition_variable m_answered;
  std::optional<Reply<Answer>> m_last;  ///< guarded by m_delivering
  RequestWorker<Numbered> m_worker;     ///< last: stopped before the members it uses are destroyed
};

}  // namespace geargraph
