#pragma once

#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/expected.h"
#include "core/mechanism/mechanism.h"

namespace geargraph {

// Places of links in drawings other than the digraph. Each such drawing keeps them in a member of the
// document's `view` of its own, `"ttNodes": {"4": [130, 190]}`, which only it reads: for the rest of the
// program it is a member to be kept as it is.

/// Where the links of the T-T graph stand that somebody has dragged.
constexpr std::string_view kTtNodes = "ttNodes";

using ViewPlaces = std::map<LinkId, SheetPoint>;

/// The places that a member holds, of links that the document has. What is no place is passed over.
/// Cost: linear in the member's text.
[[nodiscard]] ViewPlaces viewPlaces(const Mechanism& mechanism, std::string_view member);

/// The document with these links at these places too. Refuses unknown-id.
[[nodiscard]] Expected<Mechanism> withViewPlaces(Mechanism mechanism, std::string_view member,
                                                 const std::vector<std::pair<LinkId, SheetPoint>>& places);
/// The document without places of links that it has no more: a new link of an old id would stand there.
[[nodiscard]] Mechanism withoutLostPlaces(Mechanism mechanism, std::string_view member);
/// The document without the member.
[[nodiscard]] Mechanism withoutViewPlaces(Mechanism mechanism, std::string_view member);

}  // namespace geargraph
