#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/design/teeth_wish/teeth_wish.h"
#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// What a certificate claims, as it is written.
struct TeethCertificate {
  struct Term {
    std::int64_t factor = 0;
    std::vector<int> wheels;
  };
  struct Ratio {
    std::vector<Term> numerator;
    std::vector<Term> denominator;
  };
  struct Wheel {
    std::vector<int> ends;  ///< 2 * mesh for the tail, 2 * mesh + 1 for the head
    int copies = 1;
  };
  /// tried, turns, clears, assembles, hunting, undercut, within.
  using Counts = std::array<std::int64_t, 7>;
  struct Branch {
    int teeth = 0;
    Counts counts{};
  };
  struct Choice {
    std::vector<int> teeth;
    std::vector<Rational> ratios;
    std::vector<Rational> errors;
  };

  std::string mark;
  std::string problem;  ///< its canonical text
  Mechanism mechanism;
  TeethWish wish;
  std::vector<Wheel> wheels;
  std::vector<int> order;
  int first = -1;  ///< the wheel whose teeth name the branches; -1: none
  std::vector<Ratio> ratios;
  Counts counts{};
  std::vector<Branch> branches;
  std::vector<Choice> choices;
};

/// Rejects `syntax`, `format`, `version` and `schema`; numbers of wheels and ends are within their lists.
[[nodiscard]] Expected<TeethCertificate> readTeethCertificate(std::string_view text);

}  // namespace geargraph
