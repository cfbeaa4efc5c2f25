#pragma once

namespace geargraph {

/// "file.cpp:12: condition" of the failed GEARGRAPH_REQUIRE that is ending the program; else empty. For crash
/// reports: safe to call in a signal handler.
[[nodiscard]] const char* brokenContract();

}  // namespace geargraph
