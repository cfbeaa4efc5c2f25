#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"

namespace geargraph {

/// What is left of the claims of a certificate.
struct TeethVerdict {
  bool isComplete = false;          ///< all choices were gone through again
  std::vector<std::string> faults;  ///< sentences; none: every claim holds
  std::int64_t tried = 0;           ///< choices that were counted again
  std::int64_t within = 0;          ///< of these within the bounds
  std::size_t choices = 0;          ///< that the certificate lists

  [[nodiscard]] bool holds() const { return isComplete && faults.empty(); }
};

/// Goes through all choices of a certificate (`geargraph-teeth-certificate`) again, with code that shares
/// nothing with the search but the reader of wishes:
///
/// 1. The mark is that of the problem; the wheels part the ends of all meshes.
/// 2. Each ratio is the stated quotient of polynomials: at 6 random tooth counts up to 2^20 it is the ratio
///    that the states of the mechanism have (a wrong polynomial of degree d agrees with probability below
///    (d / 2^20)^6).
/// 3. Every assignment of teeth within the limits is tried, one wheel after the other in the stated order;
///    centre distances, ratios and planets are judged one by one, and the counts of every branch compared.
/// 4. The listed choices are the best ones, with these ratios and errors.
///
/// Rejects what readTeethCertificate() rejects, and errors of the mechanism. Not complete if `stop` was
/// requested. Cost: 0.1 to 3 us for each choice within the limits.
[[nodiscard]] Expected<TeethVerdict> checkTeeth(std::string_view certificate,
                                                const std::stop_token& stop = {});

/// `geargraph-teeth-check` (resources/schema/README.md).
[[nodiscard]] std::string verdictJson(const TeethVerdict& verdict);

}  // namespace geargraph
