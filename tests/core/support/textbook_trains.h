#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/mechanism/model/mechanism.h"

namespace geargraph::test {

/// A gear train whose motion is known from elsewhere: from the textbook's formula, worked by hand at each
/// train. The mechanism's inputs carry the speeds that the known rates belong to.
struct TextbookTrain {
  std::string name;
  Mechanism mechanism;
  int freedoms = 0;
  int rank = 0;
  std::vector<std::pair<int, Rational>> rates;  ///< joint by ordinal, its rate
};

/// Spur pair, planetary trains with each member held and with up to five planets, Ferguson's paradox,
/// Humpage's reduction, bevel differential, Ravigneaux, Simpson, a bevel wrist, locked and movable rings of
/// wheels.
[[nodiscard]] std::vector<TextbookTrain> textbookTrains();

/// A closed ring of four wheels' shafts on the ground: shaft k meshes the next with teeth[k].first against
/// teeth[k].second, twice as many wheels as shafts. It moves exactly if the products of both sides agree.
[[nodiscard]] Mechanism ringOfShafts(const std::vector<std::pair<int, int>>& teeth);

}  // namespace geargraph::test
