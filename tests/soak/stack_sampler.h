#pragma once

#include <pthread.h>

#include <cstddef>
#include <string>
#include <vector>

namespace geargraph::test {

/// Stacks of the thread that made it, taken by another thread through a signal (SIGPROF): what a thread is at
/// while it does not answer. One at a time per process.
class StackSampler {
 public:
  StackSampler();
  ~StackSampler();
  StackSampler(const StackSampler&) = delete;
  StackSampler& operator=(const StackSampler&) = delete;

  /// Of another thread: asks for one more stack. The first kMaxSamples since the last clear() are kept. Does
  /// nothing under the address sanitizer. Where code made at run time is registered with the unwinder, as
  /// that of a software OpenGL is, the unwinder allocates: a signal that comes while the allocator is locked
  /// then hangs the thread. So it serves a person who looks for a stall, and no test of drawing.
  void sample() const;

  // On the sampled thread:
  void clear();
  [[nodiscard]] std::size_t count() const;
  /// The functions that most of the samples are in, the outermost first: "62 % geargraph::f(int)". Functions
  /// without symbols are left out. Cost: some ms, of symbols.
  [[nodiscard]] std::vector<std::string> commonPath() const;

  static constexpr std::size_t kMaxSamples = 400;

 private:
  pthread_t m_thread;
};

}  // namespace geargraph::test
