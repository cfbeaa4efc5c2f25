#pragma once

#include <string>
#include <vector>

#include "core/design/atlas/identify.h"
#include "core/foundations/files/json_writer.h"

namespace geargraph::cli {

/// Writes the members "axes", lists of links from 1, and "meshes", lists of gear, gear and carrier.
void writeChainMembers(JsonWriter& json, const Chain& chain);

/// Writes the relatives of a chain as an object.
void writeRelatives(JsonWriter& json, const ChainRelatives& relatives);

/// "6-1.5.2 6-1.5.3", "none" where there are none; the first dozen and how many more.
[[nodiscard]] std::string numbersText(const std::vector<ChainNumber>& numbers);

/// The relatives of a chain, a line each, indented.
[[nodiscard]] std::string relativesText(const ChainRelatives& relatives);

/// Why these meshes of a chain cannot turn.
[[nodiscard]] std::string lockedText(const Chain& chain, const std::vector<int>& meshes);

}  // namespace geargraph::cli
