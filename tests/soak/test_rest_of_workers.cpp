// Plain main(), no Qt, as core.request_worker; apart from it because it measures.

#include <chrono>
#include <cstdio>
#include <future>

#include "core/foundations/base/request_worker.h"

int main() {
  using namespace geargraph;
  using Clock = std::chrono::steady_clock;
  std::promise<Clock::time_point> begun;
  RequestWorker<int> worker(
      [&](int request, const std::stop_token&) {
        if (request == 2) begun.set_value(Clock::now());
      },
      Urgency::background);
  worker.request(1);
  const Clock::time_point asked = Clock::now();
  worker.request(2);
  if (begun.get_future().get() - asked >= kRest) return 0;
  std::puts("FAIL: background work begins while a drag goes on");
  return 1;
}
