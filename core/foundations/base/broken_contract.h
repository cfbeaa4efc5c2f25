#pragma once

namespace geargraph::inline base {

/// "file.cpp:12: condition" of the GEARGRAPH_REQUIRE that failed and is ending the program; empty while all
/// hold. For crash reports: it may be read in a signal handler.
[[nodiscard]] const char* brokenContract();

}  // namespace geargraph::inline base
