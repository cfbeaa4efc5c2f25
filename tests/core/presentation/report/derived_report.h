#pragma once

#include <memory>
#include <utility>

#include "core/presentation/report/report.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::test {

inline Report reportOf(Mechanism mechanism) {
  return derivationReport(analyze(std::make_shared<const Mechanism>(std::move(mechanism))));
}

}  // namespace geargraph::test
