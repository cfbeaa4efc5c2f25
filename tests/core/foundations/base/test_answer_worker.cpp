// Plain main(), no Qt: this program also runs under the thread sanitizer.

#include <atomic>
#include <cstdio>
#include <future>
#include <new>
#include <stdexcept>
#include <vector>

#include "core/foundations/base/answer_worker.h"

namespace geargraph {
namespace {

using Worker = AnswerWorker<int, int>;

int failures = 0;

void check(bool holds, const char* what) {
  if (holds) return;
  ++failures;
  std::printf("FAIL: %s\n", what);
}

/// All replies that were delivered, in their order.
class Mailbox {
 public:
  Worker::Deliver deliver() {
    return [this](const Reply<int>& reply) { m_replies.push_back(reply); };
  }
  /// @pre no more come: the worker is gone, or the last one has been awaited
  [[nodiscard]] const std::vector<Reply<int>>& replies() const { return m_replies; }

 private:
  std::vector<Reply<int>> m_replies;  ///< the worker delivers one at a time
};

constexpr std::chrono::seconds kLong{60};

void theNewestRequestIsAnsweredAndAwaited() {
  Mailbox mailbox;
  std::optional<Reply<int>> last;
  std::uint64_t number = 0;
  {
    Worker worker([](int request, const Worker::Responder& respond) { respond(10 * request); },
                  mailbox.deliver());
    for (int request = 1; request <= 100; ++request) number = worker.request(request);
    last = worker.await(number, kLong);
  }
  check(number == 100, "requests are numbered from 1");
  check(last && last->answer == 1000 && last->isLast, "the newest answer is awaited");
  check(mailbox.replies().back().answer == 1000, "and delivered last");
  std::uint64_t before = 0;
  for (const Reply<int>& reply : mailbox.replies()) {
    check(reply.number > before, "in the order of the requests");
    before = reply.number;
  }
}

void aSupersededRequestStopsAndIsNotAnswered() {
  Mailbox mailbox;
  std::promise<void> begun;
  {
    Worker worker(
        [&](int request, const Worker::Responder& respond) {
          if (request == 0) {
            begun.set_value();
            while (!respond.stop().stop_requested()) std::this_thread::yield();
          }
          respond(request);
        },
        mailbox.deliver());
    worker.request(0);
    begun.get_future().wait();
    check(worker.await(worker.request(1), kLong).has_value(), "the request that overtook is answered");
  }
  check(mailbox.replies().size() == 1 && mailbox.replies().front().answer == 1, "and no other");
}

void aCancelledRequestIsNotAnswered() {
  Mailbox mailbox;
  std::promise<void> begun;
  {
    Worker worker(
        [&](int, const Worker::Responder& respond) {
          begun.set_value();
          while (!respond.stop().stop_requested()) std::this_thread::yield();
          respond(1);
        },
        mailbox.deliver(), Urgency::prompt, Superseded::delivered);
    const std::uint64_t number = worker.request(0);
    begun.get_future().wait();
    worker.cancel();
    check(!worker.await(number, std::chrono::milliseconds(1)), "nothing is awaited in vain for long");
  }
  check(mailbox.replies().empty(), "nothing is delivered");
}

void partsComeFirstAndExceptionsLast() {
  Mailbox mailbox;
  Worker worker(
      [](int, const Worker::Responder& respond) {
        respond.partly(1);
        throw std::runtime_error("no room");
      },
      mailbox.deliver());
  const auto last = worker.await(worker.request(0), kLong);
  check(last && !last->answer && last->failure == "no room", "what failed says why");
  check(mailbox.replies().size() == 2, "a part and the failure");
  check(mailbox.replies().front().answer == 1 && !mailbox.replies().front().isLast, "the part comes first");
}

void lackOfMemoryIsToldInTheCurrentLanguage() {
  const auto failure = [] {
    Mailbox mailbox;
    Worker worker([](int, const Worker::Responder&) { throw std::bad_alloc(); }, mailbox.deliver());
    const auto last = worker.await(worker.request(0), kLong);
    return last ? last->failure : std::string();
  };
  check(failure() == "there is not enough memory", "lack of memory is told");
  setCatalogue([](const char* text, int) { return "<" + std::string(text) + ">"; });
  check(failure() == "<there is not enough memory>", "in the current language");
  setCatalogue(nullptr);
}

/// Several threads ask, cancel and wait, and the worker goes while it works.
void askedFromEverywhereItStaysWhole() {
  for (int round = 0; round < 30; ++round) {
    std::atomic<bool> alive = true;
    std::atomic<int> late = 0;
    {
      Worker worker(
          [](int request, const Worker::Responder& respond) {
            for (int part = 0; part < 20 && !respond.stop().stop_requested(); ++part) respond.partly(part);
            respond(request);
          },
          [&](const Reply<int>&) {
            if (!alive) ++late;
          });
      std::vector<std::jthread> threads;
      for (int thread = 0; thread < 3; ++thread) {
        threads.emplace_back([&worker, thread] {
          for (int request = 0; request < 50; ++request) {
            const std::uint64_t number = worker.request(request);
            if (request % 10 == thread) static_cast<void>(worker.await(number, std::chrono::milliseconds(1)));
            if (request % 17 == thread) worker.cancel();
          }
        });
      }
    }
    alive = false;
    check(late == 0, "nothing is delivered after the destructor");
  }
}

}  // namespace
}  // namespace geargraph

int main() {
  geargraph::theNewestRequestIsAnsweredAndAwaited();
  geargraph::aSupersededRequestStopsAndIsNotAnswered();
  geargraph::aCancelledRequestIsNotAnswered();
  geargraph::partsComeFirstAndExceptionsLast();
  geargraph::lackOfMemoryIsToldInTheCurrentLanguage();
  geargraph::askedFromEverywhereItStaysWhole();
  std::printf("%d failures\n", geargraph::failures);
  return geargraph::failures == 0 ? 0 : 1;
}
