#pragma once

#include <memory>
#include <utility>

#include "core/theory/analysis/analysis.h"

namespace geargraph::test {

inline SnapshotPtr snapshotOf(Mechanism mechanism) {
  return analyze(std::make_shared<const Mechanism>(std::move(mechanism)));
}

}  // namespace geargraph::test
