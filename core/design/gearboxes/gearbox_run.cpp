#include "core/design/gearboxes/gearbox_run.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <iterator>
#include <map>
#include <mutex>
#include <thread>

#include "core/design/gearboxes/gearbox_document.h"

namespace geargraph {
namespace {

/// The layouts of one shard, searched block by block on several threads; blocks are passed on in their order.
class GearboxRun {
 public:
  GearboxRun(const GearboxWish& wish, const GearboxRunOptions& options, std::vector<GearLayout> layouts,
             std::int64_t total, const std::stop_token& stop)
      : m_wish(wish),
        m_problem(searchProblem(wish)),
        m_options(options),
        m_layouts(std::move(layouts)),
        m_stop(stop),
        m_passed(options.from) {
    m_result.layouts = total;
  }

  std::optional<GearboxSearch> run() {
    const auto blocks =
        (static_cast<std::int64_t>(m_layouts.size()) - m_options.from + kBlockLayouts - 1) / kBlockLayouts;
    const auto threads =
        static_cast<int>(std::clamp<std::int64_t>(m_options.threads, 1, std::max<std::int64_t>(blocks, 1)));
    {
      std::vector<std::jthread> others;
      for (int i = 1; i < threads; ++i) others.emplace_back([this] { work(); });
      work();
    }
    if (m_stop.stop_requested() || m_isEnded) return std::nullopt;
    return std::move(m_result);
  }

 private:
  void work() {
    const auto count = static_cast<std::int64_t>(m_layouts.size());
    while (!m_isEnded && !m_stop.stop_requested()) {
      const std::int64_t block = m_next++;
      const std::int64_t from = m_options.from + block * kBlockLayouts;
      if (from >= count) return;
      GearboxSearch found = searched(from, std::min(from + kBlockLayouts, count));
      if (m_stop.stop_requested()) return;
      pass(block, std::move(found));
    }
  }

  GearboxSearch searched(std::int64_t from, std::int64_t to) const {
    GearboxSearch block;
    block.layouts = m_result.layouts;
    for (std::int64_t at = from; at < to && !m_stop.stop_requested(); ++at) {
      const auto candidates =
          searchLayout(m_problem, m_layouts[static_cast<std::size_t>(at)], block.counts, m_stop);
      for (const GearboxCandidate& each : candidates) {
        if (m_stop.stop_requested()) return block;
        auto gearbox = judged(m_wish, each, block.judged);
        if (!gearbox) continue;
        if (checkByDocument(m_wish, *gearbox, false, m_stop) == GearboxCheck::right)
          block.found.push_back(*std::move(gearbox));
      }
      ++block.searched;
    }
    return block;
  }

  /// Keeps a block until those before it are passed on.
  void pass(std::int64_t block, GearboxSearch found) {
    const std::lock_guard lock(m_mutex);
    m_waiting.emplace(block, std::move(found));
    while (!m_waiting.empty() && m_waiting.begin()->first == m_nextToPass && !m_isEnded) {
      GearboxSearch next = std::move(m_waiting.begin()->second);
      m_waiting.erase(m_waiting.begin());
      ++m_nextToPass;
      m_passed += next.searched;
      if (m_options.onBlock &&
          !m_options.onBlock(next, m_passed, static_cast<std::int64_t>(m_layouts.size())))
        m_isEnded = true;
      m_result.add(std::move(next));
    }
  }

  const GearboxWish& m_wish;
  SearchProblem m_problem;
  const GearboxRunOptions& m_options;
  std::vector<GearLayout> m_layouts;
  std::stop_token m_stop;
  std::atomic<std::int64_t> m_next = 0;
  std::atomic<bool> m_isEnded = false;
  std::mutex m_mutex;
  std::map<std::int64_t, GearboxSearch> m_waiting;  // guarded by m_mutex, as what follows
  std::int64_t m_nextToPass = 0;
  std::int64_t m_passed;
  GearboxSearch m_result;
};

}  // namespace

void GearboxSearch::add(GearboxSearch other) {
  searched += other.searched;
  counts += other.counts;
  judged += other.judged;
  std::move(other.found.begin(), other.found.end(), std::back_inserter(found));
}

bool hasTooFewStates(const GearboxWish& wish) {
  const auto sets = static_cast<int>(basicSets(wish.limits.kinds).size());
  const int engaged = wish.limits.shafts - sets - 1;
  const auto wanted = wish.forward.size() + (wish.reverse == ReverseWish::none ? 0 : 1);
  std::size_t states = 1;
  for (int i = 0; i < engaged; ++i)
    states =
        states * static_cast<std::size_t>(std::max(0, wish.elements - i)) / static_cast<std::size_t>(i + 1);
  return states < wanted;
}

std::optional<GearboxSearch> findGearboxes(const GearboxWish& wish, const GearboxRunOptions& options,
                                           const std::stop_token& stop) {
  auto all = gearLayouts(wish.limits, stop);
  if (!all) return std::nullopt;
  std::vector<GearLayout> own;
  for (std::size_t i = static_cast<std::size_t>(options.shard.part); i < all->size();
       i += static_cast<std::size_t>(options.shard.count))
    own.push_back((*all)[i]);
  const auto total = static_cast<std::int64_t>(all->size());
  all.reset();
  const bool isHopeless = hasTooFewStates(wish);
  if (isHopeless) {
    GearboxSearch result;
    result.layouts = total;
    result.searched = static_cast<std::int64_t>(own.size()) - options.from;
    result.isComplete = true;
    if (options.onBlock)
      options.onBlock(result, static_cast<std::int64_t>(own.size()), static_cast<std::int64_t>(own.size()));
    return result;
  }
  auto result = GearboxRun(wish, options, std::move(own), total, stop).run();
  if (result) {
    result->isComplete = total == 0;
    std::sort(result->found.begin(), result->found.end(), ranksBefore);
  }
  return result;
}

}  // namespace geargraph
