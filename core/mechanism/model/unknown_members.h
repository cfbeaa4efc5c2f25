#pragma once

#include <string_view>

#include "core/foundations/base/diagnostic.h"
#include "core/mechanism/model/mechanism.h"
#include "core/mechanism/model/member_info.h"

namespace geargraph {

/// unknown-member: members of a document that this program does not know, one diagnostic for each name and
/// kind of object, with all elements that have it, and the nearest known name where it looks like a slip.
/// They are kept and change nothing. Cost: O(n), and O(known names) for each unknown one.
[[nodiscard]] Diagnostics unknownMemberDiagnostics(const Mechanism& mechanism);

/// The member that is surely meant by a common misspelling, e.g. "efficiency" by "efficency"; empty for other
/// names. The reader of documents rejects it in objects that may have that member.
[[nodiscard]] std::string_view misspelledMember(std::string_view name);

}  // namespace geargraph
