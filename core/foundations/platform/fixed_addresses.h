#pragma once

namespace geargraph {

/// Starts the program again with the same addresses in each run, if they are not already, so that what is in
/// the order of addresses is in the same order. `words` are those of main(), the last one null. Returns where
/// that was so already, failed, or the system has no such call.
void restartWithFixedAddresses(char** words);

}  // namespace geargraph
