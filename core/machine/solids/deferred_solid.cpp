#include "core/machine/solids/deferred_solid.h"

#include <utility>

namespace geargraph {

const std::shared_ptr<const Solid>& DeferredSolid::solid() const {
  std::call_once(m_once, [this] {
    m_solid = std::make_shared<const Solid>(std::exchange(m_make, nullptr)());
    m_ready = m_solid.get();
  });
  return m_solid;
}

}  // namespace geargraph
