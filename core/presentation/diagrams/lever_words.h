#pragma once

#include <string>

#include "core/foundations/base/rational.h"
#include "core/mechanism/model/mechanism.h"
#include "core/theory/levers/lever_plan.h"

namespace geargraph {

// The words of levers, the same in every view of them and on the command line.

/// Why there is no lever, as a sentence. @pre the plan has none
[[nodiscard]] std::string absenceSentence(const Mechanism& mechanism, const LeverPlan& plan);

/// "set 1", "sets 1 and 2", by the mesh groups of a lever; empty where it has none.
[[nodiscard]] std::string setsOf(const Lever& lever);
/// "48 : 96", of several sets "33 : 73, 33 : 73".
[[nodiscard]] std::string teethOf(const LeverPlan& plan, const Lever& lever);

/// "3, 5": the labels of links.
[[nodiscard]] std::string labelsOf(const std::vector<LinkOrdinal>& links);

/// "Links 3, 5 turn as one.", or that they do by these tooth counts only.
[[nodiscard]] std::string turnsAsOne(const std::vector<LinkOrdinal>& links, bool isByMeshes);

/// A whole number, or three decimals rounded from the fraction, ties to even, with the minus sign and the
/// decimal sign of the language; "≈ 0" is never written as 0: smaller numbers get more decimals.
[[nodiscard]] std::string threeDecimals(const Rational& value);

}  // namespace geargraph
