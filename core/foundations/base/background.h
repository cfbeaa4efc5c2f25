#pragma once

namespace geargraph::inline base {

/// From now on the calling thread takes of the processors what others leave: for work that nobody waits for
/// while there is other work. It still gets on where others never rest. Where the system has no such thing,
/// nothing.
void workInBackground();

}  // namespace geargraph::inline base
