#pragma once

namespace geargraph {

/// Characters a field for a name or a number takes: more than a document may have (1,000 and 4,300), so that
/// what is too long is refused with its reason and never cut to something valid. A document that is pasted
/// by mistake is cut: all of it would be laid out as one line.
inline constexpr int kMaxTyped = 10'000;

/// Characters a search field takes.
inline constexpr int kMaxSearched = 200;

}  // namespace geargraph
