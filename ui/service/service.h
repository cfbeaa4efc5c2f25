#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <utility>

#include "core/foundations/base/answer_worker.h"
#include "ui/service/service_signals.h"

namespace geargraph::inline ui_service {

template <class Request, class Answer>
struct ServiceOptions {
  Urgency urgency = Urgency::prompt;
  Overtaken overtaken = Overtaken::dropped;
  /// Do both requests have the same answer? Then the newer one is not worked on. Without it no two have.
  std::function<bool(const Request& before, const Request& now)> same = {};
  /// Called with every answer on the thread that has made it, before the GUI thread hears of it, so that
  /// further work begins while that is busy; never on two threads at once.
  std::function<void(const Answer& answer)> ahead = {};
};

/// Answers requests of a window on a thread of its own (AnswerWorker); the newest request wins. Answers
/// arrive on the GUI thread, and none to an overtaken request reaches a view, unless
/// ServiceOptions::overtaken asks for that.
///
/// request() may be called from any thread, all else from the thread of the object.
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
        m_overtaken(options.overtaken),
        m_worker(
            std::move(work),
            [this, ahead = std::move(options.ahead)](const Reply<Answer>& reply) {
              if (ahead && reply.answer) ahead(*reply.answer);
              QMetaObject::invokeMethod(
                  this, [this, reply]() mutable { arrived(std::move(reply)); }, Qt::QueuedConnection);
            },
            options.urgency, options.overtaken) {}

  /// False where the answer to the last request, there or on its way, is that to this one too.
  bool request(Request request) {
    const std::lock_guard lock(m_asking);
    const bool isSame = m_same && m_request && m_same(*m_request, request);
    if (m_same) m_request = request;
    if (!isSame) m_wanted = m_worker.request(std::move(request));
    return !isSame;
  }
  /// Waits for the newest request's last answer, if it comes soon enough: answered() is then emitted at once.
  void await(std::chrono::milliseconds most) {
    if (isComplete()) return;
    if (auto reply = m_worker.await(wanted(), most)) arrived(*std::move(reply));
  }
  /// No request is open any more: nothing that has been asked for will arrive.
  void cancel() {
    m_worker.cancel();
    forgetRequest();
    m_arrived = wanted();
    m_isComplete = true;
  }

  void tellToEnd() override { m_worker.tellToEnd(); }
  [[nodiscard]] bool hasEnded() const override { return m_worker.hasEnded(); }

  /// The newest one that has arrived; default-constructed before the first.
  [[nodiscard]] const Answer& answer() const { return m_answer; }
  /// Has the newest request been answered, if only partly?
  [[nodiscard]] bool isUpToDate() const { return m_arrived == wanted(); }
  /// Has all of it been answered?
  [[nodiscard]] bool isComplete() const { return isUpToDate() && m_isComplete; }

  /// Calls `receive(answer)` for every answer, until `context` is destroyed.
  template <class Receive>
  void onAnswer(QObject* context, Receive receive) {
    connect(this, &ServiceSignals::answered, context, [this, receive] { std::invoke(receive, m_answer); });
  }

 protected:
  /// The next request is worked on, whatever `same` says of it.
  void forgetRequest() {
    const std::lock_guard lock(m_asking);
    m_request.reset();
  }
  /// The answer until another one arrives.
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
    if (reply.number != wanted() && m_overtaken == Overtaken::dropped) return;
    m_arrived = reply.number;
    m_isComplete = reply.isLast;
    if (reply.answer) return setAnswer(*std::move(reply.answer));
    forgetRequest();
    emit failed(QString::fromStdString(reply.failure));
  }

  std::function<bool(const Request&, const Request&)> m_same;
  Overtaken m_overtaken;
  mutable std::mutex m_asking;
  std::uint64_t m_wanted = 0;        ///< number of the newest request; guarded by m_asking
  std::optional<Request> m_request;  ///< the newest, if `same` has to know it; guarded by m_asking
  std::uint64_t m_arrived = 0;       ///< number of the newest request that has been answered
  bool m_isComplete = true;          ///< not only partly
  Answer m_answer{};
  Worker m_worker;  ///< last: it is stopped before what its replies touch goes
};

}  // namespace geargraph::inline ui_service
