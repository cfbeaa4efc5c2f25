#pragma once

#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The version of the format that a document needs: the newest of those since which its members and values
/// exist (MemberInfo::since, PairKind::since). A member that equals its default is not written and needs
/// none. A document therefore keeps its bytes when members are added to the format, and a program that does
/// not know one rejects the document instead of misreading it. From 1 to kFileVersion. Cost: O(document).
[[nodiscard]] int fileVersionOf(const Mechanism& mechanism);

}  // namespace geargraph
