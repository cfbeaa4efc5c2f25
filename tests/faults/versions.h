#pragma once

#include <optional>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::test {

/// A document that differs from every other version and says in its name which it is: the paper's robot with
/// notes of up to 300,000 characters, so that writing it takes several calls. The same number gives the same
/// document.
[[nodiscard]] Mechanism version(int number);
/// Which version a document is, by its name; nothing where it is none, or not wholly that one.
[[nodiscard]] std::optional<int> versionOf(const Mechanism& mechanism);

}  // namespace geargraph::test
