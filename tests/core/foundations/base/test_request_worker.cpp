// Plain main(), no Qt: this program also runs under the thread sanitizer.

#include <atomic>
#include <cstdio>
#include <future>
#include <thread>
#include <vector>

#include "core/foundations/base/request_worker.h"
#include "core/foundations/platform/system.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace geargraph {
namespace {

int failures = 0;

void check(bool holds, const char* what) {
  if (holds) return;
  ++failures;
  std::printf("FAIL: %s\n", what);
}

/// Work on request 0 begins, and goes on until it is asked to stop.
struct Endless {
  std::promise<void> begun;
  std::atomic<bool> stopped = false;

  void operator()(const std::stop_token& stop) {
    begun.set_value();
    while (!stop.stop_requested()) std::this_thread::yield();
    stopped = true;
  }
};

void theNewestRequestStopsTheOneUnderWayAndDropsTheOthers() {
  Endless endless;
  std::vector<int> done;
  std::promise<void> last;
  {
    RequestWorker<int> worker([&](int request, const std::stop_token& stop) {
      if (request == 0) return endless(stop);
      done.push_back(request);
      check(!stop.stop_requested(), "the newest request is not asked to stop");
      last.set_value();
    });
    worker.request(0);
    endless.begun.get_future().wait();
    worker.request(7);
    last.get_future().wait();
  }
  check(endless.stopped, "the work under way is asked to stop");
  check(done == std::vector<int>{7}, "the newest request is worked off");
}

void whatGoesOnElsewhereIsAskedToStopToo() {
  std::promise<std::stop_token> token;
  RequestWorker<int> worker([&](int request, const std::stop_token& stop) {
    if (request == 0) token.set_value(stop);
  });
  worker.request(0);
  const std::stop_token stop = token.get_future().get();
  check(!stop.stop_requested(), "it goes on while nothing newer is wanted");
  worker.request(1);
  check(stop.stop_requested(), "a newer request asks it to stop, whether or not the call is over");
}

#ifdef __linux__
void workInTheBackgroundTakesWhatIsLeft() {
  if (platformName() != "Linux") return;  // the portable layer knows no priorities
  std::promise<int> priority;
  RequestWorker<int> worker(
      [&](int, const std::stop_token&) {
        priority.set_value(getpriority(PRIO_PROCESS, static_cast<id_t>(gettid())));
      },
      Urgency::background);
  worker.request(0);
  const int own = getpriority(PRIO_PROCESS, static_cast<id_t>(gettid()));
  check(own == 19 || priority.get_future().get() > own, "a lower priority than this thread's");
}
#endif

void supersededRequestsAreDropped() {
  std::promise<void> begun;
  std::promise<void> go;
  std::promise<void> last;
  std::vector<int> done;
  RequestWorker<int> worker([&](int request, const std::stop_token&) {
    if (request == 0) {
      begun.set_value();
      go.get_future().wait();
    } else {
      done.push_back(request);
      last.set_value();
    }
  });
  worker.request(0);
  begun.get_future().wait();
  for (int request = 1; request <= 100; ++request) worker.request(request);
  go.set_value();
  last.get_future().wait();
  check(done == std::vector<int>{100}, "of many waiting requests the newest is worked off");
}

void theDestructorStopsTheWorkUnderWayAndBeginsNoMore() {
  Endless endless;
  std::atomic<int> begun = 0;
  {
    RequestWorker<int> worker([&](int request, const std::stop_token& stop) {
      ++begun;
      if (request == 0) endless(stop);
    });
    worker.request(0);
    endless.begun.get_future().wait();
  }
  check(endless.stopped, "the destructor stops the work under way");
  check(begun == 1, "and nothing else is begun");
}

void manyAreToldToEndBeforeOneIsWaitedFor() {
  Endless endless;
  std::promise<void> waiting;
  std::promise<void> go;
  std::atomic<int> begun = 0;
  RequestWorker<int> quick([&](int, const std::stop_token& stop) { endless(stop); });
  RequestWorker<int> slow([&](int, const std::stop_token&) {
    ++begun;
    waiting.set_value();
    go.get_future().wait();  // what cannot stop soon
  });
  quick.request(0);
  slow.request(0);
  endless.begun.get_future().wait();
  waiting.get_future().wait();
  check(!quick.hasStopped() && !slow.hasStopped(), "nothing ends by itself");
  slow.requestStop();
  quick.requestStop();
  while (!quick.hasStopped()) std::this_thread::yield();
  check(endless.stopped, "what is told to end is asked to stop");
  check(!slow.hasStopped(), "and nobody has waited for the other");
  slow.request(1);
  go.set_value();
  while (!slow.hasStopped()) std::this_thread::yield();
  check(begun == 1, "nothing is begun once it is told to end");
}

}  // namespace
}  // namespace geargraph

int main() {
  geargraph::theNewestRequestStopsTheOneUnderWayAndDropsTheOthers();
  geargraph::whatGoesOnElsewhereIsAskedToStopToo();
#ifdef __linux__
  geargraph::workInTheBackgroundTakesWhatIsLeft();
#endif
  geargraph::supersededRequestsAreDropped();
  geargraph::theDestructorStopsTheWorkUnderWayAndBeginsNoMore();
  geargraph::manyAreToldToEndBeforeOneIsWaitedFor();
  std::printf("%d failures\n", geargraph::failures);
  return geargraph::failures == 0 ? 0 : 1;
}
