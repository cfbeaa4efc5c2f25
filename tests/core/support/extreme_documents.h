#pragma once

#include "core/mechanism/model/mechanism.h"

namespace geargraph::test {

/// The paper's robot with bevels of 20,000 and 30,000 teeth, beside each other.
[[nodiscard]] Mechanism robotOfManyTeeth();

/// The example with its bearings at the ends of the range that lengths have (kLargestLength).
[[nodiscard]] Mechanism farOffsets(const char* name);

}  // namespace geargraph::test
