#pragma once

#include <string>
#include <string_view>

#include "core/design/teeth_search/teeth_answer.h"

namespace geargraph {

/// `geargraph-teeth-certificate` (resources/schema/README.md): problem, order of enumeration, the counts of
/// every branch and the best choices, which `teeth_check` checks with code of its own. `wish` is the text
/// that the answer's wish was read from, `program` the version that searched.
///
/// Rejects schema: of a search that was stopped, of wishes with a least efficiency, and of trains that lock
/// with most teeth, whose proof would need more than whole numbers.
[[nodiscard]] Expected<std::string> teethCertificate(const TeethAnswer& answer, std::string_view wish,
                                                     std::string_view program);

}  // namespace geargraph
