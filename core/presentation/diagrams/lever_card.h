#pragma once

#include <string>
#include <vector>

#include "core/presentation/diagrams/lever_picture.h"

namespace geargraph {

/// What is known of a point of a lever, for people.
struct LeverCard {
  struct Row {
    std::string name;  ///< "place"
    std::string text;
  };
  std::string title;  ///< "Link 3 (ring 1): held by brake B"
  std::vector<Row> rows;
};

/// Place, speed and torque of a point; what is not known has no row.
/// @pre all of one mechanism; there are such a lever and such a point
[[nodiscard]] LeverCard leverCard(const Mechanism& mechanism, const LeverPicture& picture, int lever,
                                  int point);

/// The same in one line, to be read aloud: "set 1: link 4, 2/3 of the way from 2 to 3, 0.719 rad/s".
[[nodiscard]] std::string pointSentence(const Mechanism& mechanism, const LeverPicture& picture, int lever,
                                        int point);

/// "1057/1471 = 0.719"; a whole number alone.
[[nodiscard]] std::string fractionAndDecimals(const Rational& value);

}  // namespace geargraph
