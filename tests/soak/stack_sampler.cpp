#include "tests/soak/stack_sampler.h"

#include <backtrace.h>
#include <cxxabi.h>
#include <execinfo.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>

namespace geargraph::test {
namespace {

constexpr std::size_t kMaxFrames = 120;
constexpr double kLeastShare = 0.4;  // of the samples, that a function is worth naming

struct Stack {
  int size = 0;
  std::array<void*, kMaxFrames> frames{};
};
// What the handler writes to, on the sampled thread.
std::array<Stack, StackSampler::kMaxSamples> stacks;
std::atomic<std::size_t> taken{0};

void takeStack(int /*signal*/) {
  const std::size_t at = taken.load(std::memory_order_relaxed);
  if (at >= stacks.size()) return;
  stacks[at].size = backtrace(stacks[at].frames.data(), static_cast<int>(kMaxFrames));
  taken.store(at + 1, std::memory_order_relaxed);
}

std::string nameOf(void* address) {
  static backtrace_state* const symbols = backtrace_create_state(
      nullptr, 1, [](void*, const char*, int) {}, nullptr);
  std::string name;
  backtrace_syminfo(
      symbols, reinterpret_cast<std::uintptr_t>(address) - 1,
      [](void* to, std::uintptr_t, const char* symbol, std::uintptr_t, std::uintptr_t) {
        if (symbol == nullptr) return;
        int status = 0;
        const std::unique_ptr<char, void (*)(void*)> plain(
            abi::__cxa_demangle(symbol, nullptr, nullptr, &status), std::free);
        *static_cast<std::string*>(to) = status == 0 ? plain.get() : symbol;
      },
      [](void*, const char*, int) {}, &name);
  return name;
}

}  // namespace

StackSampler::StackSampler() : m_thread(pthread_self()) {
  std::array<void*, 4> first{};
  backtrace(first.data(), static_cast<int>(first.size()));  // loads the unwinder, which a handler must not
  struct sigaction action {};
  action.sa_handler = &takeStack;
  action.sa_flags = SA_RESTART;
  sigaction(SIGPROF, &action, nullptr);
  taken = 0;
}

StackSampler::~StackSampler() {
  std::signal(SIGPROF, SIG_IGN);
}

void StackSampler::sample() const {
  // The unwinder may allocate, and waits for ever where the signal came while the sanitizer's allocator was
  // locked.
#ifndef __SANITIZE_ADDRESS__
  pthread_kill(m_thread, SIGPROF);
#endif
}

void StackSampler::clear() {
  taken = 0;
}

std::size_t StackSampler::count() const {
  return taken;
}

std::vector<std::string> StackSampler::commonPath() const {
  struct Seen {
    std::size_t stacks = 0;
    double depth = 0;  ///< sum, from the outermost
  };
  std::map<std::string, Seen> functions;
  std::map<void*, std::string> names;
  const std::size_t all = taken;
  for (std::size_t i = 0; i < all; ++i) {
    std::map<std::string, int> ofStack;
    for (int frame = 0; frame < stacks[i].size; ++frame) {
      void* const address = stacks[i].frames[static_cast<std::size_t>(frame)];
      const auto [name, isNew] = names.try_emplace(address);
      if (isNew) name->second = nameOf(address);
      if (!name->second.empty()) ofStack[name->second] = stacks[i].size - frame;
    }
    for (const auto& [name, depth] : ofStack) {
      ++functions[name].stacks;
      functions[name].depth += depth;
    }
  }
  std::vector<std::pair<double, std::string>> path;
  for (const auto& [name, seen] : functions) {
    const double share = static_cast<double>(seen.stacks) / static_cast<double>(all);
    if (share < kLeastShare) continue;
    path.emplace_back(seen.depth / static_cast<double>(seen.stacks),
                      std::to_string(static_cast<int>(100 * share)) + " % " + name);
  }
  std::sort(path.begin(), path.end());
  std::vector<std::string> result;
  for (auto& [depth, text] : path) {
    const bool isLoop = text.ends_with("QCoreApplication::exec()");
    const bool isOurs = text.find("takeStack") != std::string::npos;
    if (isLoop) result.clear();  // what all of them begin with
    if (!isLoop && !isOurs) result.push_back(std::move(text));
  }
  return result;
}

}  // namespace geargraph::test
