#pragma once

#include <stop_token>
#include <string>
#include <string_view>

#include "core/design/gearboxes/gearbox_run.h"
#include "core/foundations/files/json.h"

namespace geargraph {

/// The result of a search as the format "geargraph-gearboxes" (resources/schema/README.md): the first `limit`
/// gearboxes, all if it is negative, each with the losses and circulating power of its gears. std::nullopt
/// if `stop` was requested. The same bytes for the same wish, however it was searched.
[[nodiscard]] std::optional<std::string> gearboxesJson(const GearboxWish& wish, GearboxSearch search,
                                                       std::int64_t limit, const std::stop_token& stop = {});

/// A gearbox in one line of JSON that gearboxFromRecord() reads: layout, elements, gears and teeth, from
/// which all else follows.
[[nodiscard]] std::string gearboxRecord(const Gearbox& gearbox);
/// Reads a record and computes ratios, errors and measures anew. std::nullopt if it is none of this wish.
[[nodiscard]] std::optional<Gearbox> gearboxFromRecord(const GearboxWish& wish, JsonValue record);

/// The members on a link as files name them: "in", "out", "S1", ...
[[nodiscard]] std::vector<std::string> membersOn(const BasicSets& sets, const GearLayout& layout, int link);
/// One name that tells a link of an element.
[[nodiscard]] std::string linkWord(const BasicSets& sets, const GearLayout& layout, int link);

}  // namespace geargraph
