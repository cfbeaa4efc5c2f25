#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>

#include "core/machine/solids/solid.h"

namespace geargraph::inline solids {

/// A solid that is made when somebody asks for it first. Thread-safe: who asks while it is being made waits.
class DeferredSolid {
 public:
  using Make = std::function<Solid()>;

  explicit DeferredSolid(Make make) : m_make(std::move(make)) {}

  /// Cost: that of making it, once.
  [[nodiscard]] const std::shared_ptr<const Solid>& solid() const;
  /// Null where nobody has asked for it yet.
  [[nodiscard]] const Solid* made() const { return m_made.load(); }

 private:
  mutable std::once_flag m_once;
  mutable Make m_make;  ///< empty once it was called
  mutable std::shared_ptr<const Solid> m_solid;
  mutable std::atomic<const Solid*> m_made{nullptr};
};

}  // namespace geargraph::inline solids
