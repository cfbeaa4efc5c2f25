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

namespace geargraph::inline base {

/// What becomes of the answers to a request that has been overtaken.
enum class Overtaken {
  dropped,   ///< its work is asked to stop, nothing of it is delivered any more
  delivered  ///< what its work still yields is delivered: pictures that follow a drag, if late
};

/// One answer to a request, or why there is none.
template <class Answer>
struct Reply {
  std::uint64_t number = 0;      ///< of the request, from AnswerWorker::request()
  bool isLast = true;            ///< no more answers to this request follow
  std::optional<Answer> answer;  ///< none if the work failed
  std::string failure;           ///< why it failed; empty if it did not
};

/// Answers requests on one thread of its own; the newest request wins. A request is answered once, or in
/// parts of which each replaces the one before, or not at all if it is overtaken or cancelled.
///
/// The destructor asks the work under way to stop and waits for it; nothing is delivered after that.
/// Free of Qt, as RequestWorker is.
template <class Request, class Answer>
class AnswerWorker {
 public:
  /// Called on the thread that has made the reply, never on two threads at once.
  using Deliver = std::function<void(const Reply<Answer>& reply)>;

  /// Takes the answers to one request, from any thread. May be copied, and used as long as the worker exists.
  class Responder {
   public:
    /// The whole answer.
    void operator()(Answer answer) const {
      m_worker->deliver(*this, {m_number, true, std::move(answer), {}});
    }
    /// The answer as far as it is known; another one follows.
    void partly(Answer answer) const { m_worker->deliver(*this, {m_number, false, std::move(answer), {}}); }
    /// Runs a part of the work. An exception becomes a failure, which is delivered as the last reply.
    template <class Part>
    void guard(const Part& part) const {
      try {
        part();
      } catch (const std::bad_alloc&) {
        fail("there is not enough memory");
      } catch (const std::exception& error) {
        fail(error.what());
      }
    }
    /// Requested when the answer is no longer wanted.
    [[nodiscard]] const std::stop_token& stop() const { return m_stop; }

   private:
    friend class AnswerWorker;
    void fail(const char* why) const { m_worker->deliver(*this, {m_number, true, std::nullopt, why}); }
    Responder(AnswerWorker* worker, std::uint64_t number, std::stop_token stop)
        : m_worker(worker), m_number(number), m_stop(std::move(stop)) {}

    AnswerWorker* m_worker;
    std::uint64_t m_number;
    std::stop_token m_stop;
  };

  /// Called on the worker's thread, for one request at a time, guarded. It may leave the answering to threads
  /// that it owns.
  using Work = std::function<void(const Request& request, const Responder& respond)>;

  AnswerWorker(Work work, Deliver deliver, Urgency urgency = Urgency::prompt,
               Overtaken overtaken = Overtaken::dropped)
      : m_deliver(std::move(deliver)),
        m_overtaken(overtaken),
        m_worker(
            [this, work = std::move(work)](const Numbered& next, const std::stop_token& stop) {
              const Responder respond(this, next.number, stop);
              respond.guard([&] { work(next.request, respond); });
            },
            urgency) {}

  /// The number of the request: one more than that of the one before. From any thread.
  std::uint64_t request(Request request) {
    const std::lock_guard lock(m_asking);
    m_worker.request({std::move(request), ++m_newest});
    return m_newest;
  }

  /// Drops the newest request. Nothing that has been asked for is delivered any more, but for a reply that is
  /// being delivered.
  void cancel() {
    const std::lock_guard lock(m_asking);
    m_cancelled = m_newest;  // first: work that sees the stop may answer at once
    m_worker.cancel();
  }

  /// As RequestWorker's.
  void tellToEnd() { m_worker.tellToEnd(); }
  [[nodiscard]] bool hasEnded() const { return m_worker.hasEnded(); }

  /// The last reply to a request, as soon as it has been delivered; none if that takes longer than `most`.
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
    if (m_overtaken == Overtaken::dropped && from.m_stop.stop_requested()) return;
    if (reply.number <= m_cancelled) return;
    m_deliver(reply);
    if (!reply.isLast) return;
    m_last = std::move(reply);
    m_answered.notify_all();
  }

  Deliver m_deliver;
  Overtaken m_overtaken;
  std::mutex m_asking;
  std::uint64_t m_newest = 0;                  ///< guarded by m_asking
  std::atomic<std::uint64_t> m_cancelled = 0;  ///< requests up to this one are answered no more
  std::mutex m_delivering;
  std::condition_variable m_answered;
  std::optional<Reply<Answer>> m_last;  ///< guarded by m_delivering
  RequestWorker<Numbered> m_worker;     ///< last: it is stopped before what it uses goes
};

}  // namespace geargraph::inline base
