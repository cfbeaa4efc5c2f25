#pragma once

namespace geargraph::soak {

/// Keeps what the process has mapped from files (its code, libraries, fonts) in memory. A machine that takes
/// such pages back when they have not been used for a while reads them from the disk again in the middle of a
/// gesture: a stall of 50 to 150 ms that no change of the program can mend. Without the right to do so, it
/// says that.
void keepCodeResident();

}  // namespace geargraph::soak
