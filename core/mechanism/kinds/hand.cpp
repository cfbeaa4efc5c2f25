#include "core/mechanism/kinds/hand.h"

#include "core/foundations/base/translation.h"

namespace geargraph {

std::string_view handName(Hand hand) {
  return hand == Hand::right ? "right" : "left";
}

std::string handWord(Hand hand) {
  return hand == Hand::right ? translated("right-hand") : translated("left-hand");
}

std::optional<Hand> handFrom(std::string_view name) {
  for (const Hand hand : {Hand::right, Hand::left}) {
    if (name == handName(hand)) return hand;
  }
  return std::nullopt;
}

}  // namespace geargraph
