#pragma once

namespace geargraph::soak {

/// Keeps what the process has mapped from files (its code, libraries, fonts) in memory. A machine that takes
/// such pages back when they have not been used for a while reads them from the disk again in the middle of a
/// gesture: a stall of 50 to 150 ms that no change of the program can mend. Without the right to do so, it
/// says that.
void keepCodeResident();

/// Touches 1 GiB of memory, or a quarter of what is free, and gives it back: what the gestures need is taken
/// from it. A virtual machine gets a page from its host when the page is first touched; 2.2 ms per MB instead
/// of 0.4, where it was measured, which counts as CPU time of the program. The picture of a window has 8 MB.
void touchMemory();

}  // namespace geargraph::soak
