#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>

#include "core/machine/solids/solid.h"

namespace geargraph {

/// A solid that is made on first use. Thread-safe: concurrent requests wait for the first.
class DeferredSolid {
 public:
  using Make = std::function<Solid()>;

  explicit DeferredSolid(Make make) : m_make(std::move(make)) {}

  /// Cost: that of making it, once.
  [[nodiscard]] const std::shared_ptr<const Solid>& solid() const;
  /// Null if it has not been made yet.
  [[nodiscard]] const Solid* solidIfReady() const { return m_ready.load(); }

 private:
  mutable std::once_flag m_once;
  mutable Make m_make;  ///< empty once it was called
  mutable std::shared_ptr<const Solid> m_solid;
  mutable std::atomic<const Solid*> m_ready{nullptr};
};

}  // namespace geargraph
