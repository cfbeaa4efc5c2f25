// Plain main(), no Qt: this program also runs under the thread sanitizer, which the distribution's Qt is not
// built for.

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <random>

#include "core/machine/body_layout/derived_geometry.h"
#include "core/theory/analysis/worker.h"
#include "tests/core/support/mechanisms.h"

namespace geargraph {
namespace {

int failures = 0;

void check(bool holds, const char* what) {
  if (holds) return;
  ++failures;
  std::printf("FAIL: %s\n", what);
}

/// Waits for a snapshot of a revision.
class Mailbox {
 public:
  void put(SnapshotPtr snapshot) {
    const std::lock_guard lock(m_mutex);
    m_revisions.push_back(snapshot->revision);
    m_last = std::move(snapshot);
    m_arrived.notify_all();
  }
  SnapshotPtr waitFor(std::uint64_t revision) {
    std::unique_lock lock(m_mutex);
    m_arrived.wait(lock, [&] { return m_last && m_last->revision == revision; });
    return m_last;
  }
  void waitForSecondStep(std::uint64_t revision) {
    std::unique_lock lock(m_mutex);
    m_arrived.wait(lock, [&] { return m_last && m_last->revision == revision && m_last->isComplete; });
  }
  std::vector<std::uint64_t> revisions() {
    const std::lock_guard lock(m_mutex);
    return m_revisions;
  }

 private:
  std::mutex m_mutex;
  std::condition_variable m_arrived;
  SnapshotPtr m_last;
  std::vector<std::uint64_t> m_revisions;
};

DerivedGeometryPtr geometryOf(std::uint64_t seed, int n) {
  return std::make_shared<const DerivedGeometry>(test::randomTree(seed, n, n / 2));
}

void newestRequestIsAnswered() {
  Mailbox mailbox;
  AnalysisWorker worker(analysisWork(), [&](const Reply<SnapshotPtr>& reply) { mailbox.put(*reply.answer); });
  const DerivedGeometryPtr large = geometryOf(1, 2000);
  const DerivedGeometryPtr small = geometryOf(2, 10);
  for (std::uint64_t revision = 1; revision < 200; ++revision) worker.request({large, revision});
  worker.request({small, 200});
  const SnapshotPtr last = mailbox.waitFor(200);
  check(last->geometry == small, "the newest mechanism is the one that was analysed");
  check(last->graph->n() == 10, "its digraph has its links");
  const std::vector<std::uint64_t> revisions = mailbox.revisions();
  check(std::is_sorted(revisions.begin(), revisions.end()), "revisions arrive in order");
  check(revisions.size() < 200, "overtaken requests are dropped");
}

/// However quick the live part is, the second step of the newest request follows.
void everyLastRequestIsCompleted() {
  Mailbox mailbox;
  AnalysisWorker worker(analysisWork(), [&](const Reply<SnapshotPtr>& reply) { mailbox.put(*reply.answer); });
  for (std::uint64_t revision = 1; revision < 300; ++revision) {
    worker.request({geometryOf(revision, 2), revision});
    mailbox.waitForSecondStep(revision);
  }
  check(mailbox.revisions().size() == 2 * 299, "every request is answered twice");
}

void destructionInTheMiddleOfWorkIsQuiet() {
  std::mt19937_64 random(7);
  for (int round = 0; round < 50; ++round) {
    std::atomic<bool> alive = true;
    std::atomic<int> late = 0;
    {
      AnalysisWorker worker(analysisWork(), [&](const Reply<SnapshotPtr>&) {
        if (!alive) ++late;
      });
      for (int i = 0; i < 100; ++i) {
        worker.request(
            {geometryOf(random() % 5, static_cast<int>(random() % 60) + 1), static_cast<std::uint64_t>(i)});
        if (round % 2 == 0 && i == 50) break;  // half of them are destroyed mid-work
      }
    }
    alive = false;
    check(late == 0, "nothing is delivered after the destructor");
  }
}

}  // namespace
}  // namespace geargraph

int main() {
  geargraph::newestRequestIsAnswered();
  geargraph::everyLastRequestIsCompleted();
  geargraph::destructionInTheMiddleOfWorkIsQuiet();
  std::printf("%d failures\n", geargraph::failures);
  return geargraph::failures == 0 ? 0 : 1;
}
