#include <QTemporaryDir>
#include <QTest>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "tests/core/presentation/mechanism_scene/stoppable_works.h"

namespace {

/// Allocations of this thread, by which work is counted: the same in every run, whatever else the machine
/// does.
thread_local std::uint64_t allocations = 0;
/// Called before the allocation with number `at`.
thread_local std::uint64_t at = 0;
thread_local std::stop_source* toStop = nullptr;

void* counted(std::size_t size, std::size_t alignment) {
  if (++allocations == at && toStop != nullptr) toStop->request_stop();
  size = (size + alignment - 1) / alignment * alignment;
  void* memory =
      alignment > alignof(std::max_align_t) ? std::aligned_alloc(alignment, size) : std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace geargraph {
namespace {

/// Allocations that `work` makes after it was asked to stop at its allocation number `after`; none where it
/// had ended before.
std::uint64_t allocationsAfterStop(const test::StoppableWork& work, std::uint64_t after) {
  std::stop_source stop;
  allocations = 0;
  at = after;
  toStop = &stop;
  const std::any made = work(stop.get_token());
  const std::uint64_t all = allocations;
  toStop = nullptr;
  return all > after ? all - after : 0;
}

}  // namespace

/// Each kind of long work, on the worst documents known, ends soon after it is cancelled. soak.stopping_time
/// measures the same works by processor time.
class StoppingTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

 private slots:
  void cancelledWorkEndsSoon_data() {
    QTest::addColumn<test::StoppableWork>("work");
    for (const test::NamedWork& each : test::stoppableWorks(m_folder.path().toStdString()))
      QTest::addRow("%s", each.name.c_str()) << each.work;
  }
  void cancelledWorkEndsSoon() {
    QFETCH(test::StoppableWork, work);
    constexpr std::uint64_t kMaxAllocations = 100'000;
    for (const std::uint64_t after : {10, 1'000, 100'000}) {
      const std::uint64_t more = allocationsAfterStop(work, after);
      QVERIFY2(more < kMaxAllocations,
               qPrintable(QStringLiteral("%1 allocations after a stop at %2").arg(more).arg(after)));
      if (more == 0) return;
    }
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::StoppingTest)
#include "test_stopping.moc"
