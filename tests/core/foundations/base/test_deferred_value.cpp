// Plain main(), no Qt: this program also runs under the thread sanitizer.

#include <atomic>
#include <barrier>
#include <cstdio>
#include <thread>
#include <vector>

#include "core/foundations/base/deferred_value.h"

namespace geargraph {
namespace {

int failures = 0;

void check(bool holds, const char* what) {
  if (holds) return;
  ++failures;
  std::printf("FAIL: %s\n", what);
}

void valueIsComputedOnceForAllThreads() {
  std::atomic<int> computed = 0;
  const DeferredValue<int> value([&](const std::stop_token&) {
    ++computed;
    return 7;
  });
  check(computed == 0, "nothing is computed before the first request");
  constexpr int kThreads = 8;
  std::barrier together(kThreads);
  std::atomic<const int*> found = nullptr;
  std::atomic<int> equal = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < kThreads; ++i) {
      threads.emplace_back([&] {
        together.arrive_and_wait();
        const auto mine = value.get();
        const int* none = nullptr;
        if (found.compare_exchange_strong(none, mine.get()) || none == mine.get()) ++equal;
      });
    }
  }
  check(computed == 1, "one thread computes");
  check(equal == kThreads, "all threads get the same value");
  check(*value.get() == 7, "the value is the computed one");
}

/// The request that computes is cancelled while another one waits: that one computes the whole value.
void cancelledComputationIsTakenOver() {
  std::barrier underWay(2);
  std::atomic<int> computed = 0;
  const DeferredValue<int> value([&](const std::stop_token& stop) {
    if (++computed > 1) return 7;
    underWay.arrive_and_wait();
    while (!stop.stop_requested()) std::this_thread::yield();
    return -1;  // half a value
  });
  std::stop_source stop;
  std::shared_ptr<const int> cancelled = std::make_shared<const int>(0);
  std::shared_ptr<const int> other;
  std::jthread first([&] { cancelled = value.get(stop.get_token()); });
  underWay.arrive_and_wait();
  std::jthread second([&] { other = value.get(); });
  stop.request_stop();
  first.join();
  second.join();
  check(cancelled == nullptr, "the cancelled request gets nothing");
  check(other && *other == 7, "the other request gets the whole value");
  check(computed == 2, "it is computed again, once");
}

/// A waiting request ends with its own stop; the computation goes on.
void waitEndsWithTheOwnStop() {
  std::barrier underWay(2);
  std::atomic<bool> mayEnd = false;
  const DeferredValue<int> value([&](const std::stop_token&) {
    underWay.arrive_and_wait();
    while (!mayEnd) std::this_thread::yield();
    return 7;
  });
  std::shared_ptr<const int> made;
  std::jthread first([&] { made = value.get(); });
  underWay.arrive_and_wait();
  std::stop_source stop;
  std::jthread stopper([&] { stop.request_stop(); });
  check(value.get(stop.get_token()) == nullptr, "a stopped wait gets nothing");
  mayEnd = true;
  first.join();
  check(made && *made == 7, "the computation is not affected");
  check(value.get(stop.get_token()) == made, "a value that is there needs no wait");
}

}  // namespace
}  // namespace geargraph

int main() {
  geargraph::valueIsComputedOnceForAllThreads();
  geargraph::cancelledComputationIsTakenOver();
  geargraph::waitEndsWithTheOwnStop();
  std::printf(geargraph::failures == 0 ? "PASS\n" : "%d checks failed\n", geargraph::failures);
  return geargraph::failures == 0 ? 0 : 1;
}
