#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <utility>

#include "core/foundations/base/answer_worker.h"
#include "ui/service/service_signals.h"
#include "ui/service/turns.h"

namespace geargraph {

template <class Request, class Answer>
struct ServiceOptions {
  Urgency urgency = Urgency::prompt;
  Superseded superseded = Superseded::dropped;
  /// Do both requests have the same answer? Then the newer one is not computed. Empty: never.
  std::function<bool(const Request& before, const Request& now)> same = {};
  /// Called with every answer on the thread that computed it, before the GUI thread receives it, so that
  /// further work can begin while that thread is busy. Never called on two threads at once.
  std::function<void(const Answer& answer)> ahead = {};
};

/// Answers requests on a background thread (AnswerWorker); only the newest request counts. Answers arrive on
/// the GUI thread, one per turn of its event loop. Answers to superseded requests are dropped unless
/// ServiceOptions::superseded says otherwise.
///
/// request() is thread-safe; all other members are for the object's thread.
template <class Request, class Answer>
class Service : public ServiceSignals {
 public:
  using Worker = AnswerWorker<Request, Answer>;
  using Responder = typename Worker::Responder;
  using Work = typename Worker::Work;
  using Options = ServiceOptions<Request, Answer>;

  explicit Service(Work work, QObject* parent = nullptr, Options options = {})
      : ServiceSignals(parent),
        m_same(std::move(options.same)),
        m_superseded(options.superseded),
        m_worker(
            std::move(work),
            [this, ahead = std::move(options.ahead)](const Reply<Answer>& reply) {
              if (ahead && reply.answer) ahead(*reply.answer);
              QMetaObject::invokeMethod(
                  this,
                  [this, reply] { GuiTaskQueue::instance().later(this, [this, reply] { arrived(reply); }); },
                  Qt::QueuedConnection);
            },
            options.urgency, options.superseded) {}

  /// False if the answer to the last request, arrived or pending, is also the answer to this one.
  bool request(Request request) {
    const std::lock_guard lock(m_asking);
    const bool isSame = m_same && m_request && m_same(*m_request, request);
    if (m_same) m_request = request;
    if (!isSame) m_wanted = m_worker.request(std::move(request));
    return !isSame;
  }
  /// Waits at most `most` for the final answer to the newest request. If it arrives, answered() is emitted
  /// before the call returns.
  void await(std::chrono::milliseconds most) {
    if (isComplete()) return;
    if (auto reply = m_worker.await(wanted(), most)) arrived(*std::move(reply));
  }
  /// Cancels all requests: none of their answers will arrive.
  void cancel() {
    m_worker.cancel();
    forgetRequest();
    m_arrived = wanted();
    m_isComplete = true;
  }

  void requestStop() override { m_worker.requestStop(); }
  [[nodiscard]] bool hasStopped() const override { return m_worker.hasStopped(); }

  /// The last answer that arrived; default-constructed before the first.
  [[nodiscard]] const Answer& answer() const { return m_answer; }
  /// Has the newest request been answered, at least in part?
  [[nodiscard]] bool isUpToDate() const { return m_arrived == wanted(); }
  /// Has the newest request been answered completely?
  [[nodiscard]] bool isComplete() const { return isUpToDate() && m_isComplete; }

  /// Calls `receive(answer)` for every answer, until `context` is destroyed.
  template <class Receive>
  void onAnswer(QObject* context, Receive receive) {
    connect(this, &ServiceSignals::answered, context, [this, receive] { std::invoke(receive, m_answer); });
  }

 protected:
  /// The next request is computed even if `same` holds.
  void forgetRequest() {
    const std::lock_guard lock(m_asking);
    m_request.reset();
  }
  /// Sets the answer until another one arrives.
  void setAnswer(Answer answer) {
    m_answer = std::move(answer);
    emit answered();
  }

 private:
  [[nodiscard]] std::uint64_t wanted() const {
    const std::lock_guard lock(m_asking);
    return m_wanted;
  }

  void arrived(Reply<Answer> reply) {
    const bool isKnown = reply.number < m_arrived || (reply.number == m_arrived && m_isComplete);
    if (isKnown) return;  // from await(), or cancelled
    if (reply.number != wanted() && m_superseded == Superseded::dropped) return;
    m_arrived = reply.number;
    m_isComplete = reply.isLast;
    if (reply.answer) return setAnswer(*std::move(reply.answer));
    forgetRequest();
    emit failed(QString::fromStdString(reply.failure));
  }

  std::function<bool(const Request&, const Request&)> m_same;
  Superseded m_superseded;
  mutable std::mutex m_asking;
  std::uint64_t m_wanted = 0;        ///< number of the newest request; guarded by m_asking
  std::optional<Request> m_request;  ///< the newest, only if `same` is set; guarded by m_asking
  std::uint64_t m_arrived = 0;       ///< number of the newest request that has been answered
  bool m_isComplete = true;          ///< false: answered only in part
  Answer m_answer{};
  Worker m_worker;  ///< last: stopped before the members it uses are destroyed
};

}  // namespace geargraph
