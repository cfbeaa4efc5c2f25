#pragma once

#include <QString>
#include <string_view>

#include "ui/models/term_tips.h"

namespace geargraph {

/// Words or numbers of core as shownText(), with the minus sign of print.
[[nodiscard]] inline QString withMinusSign(std::string_view text) {
  return shownText(text).replace(QLatin1Char('-'), QChar(0x2212));
}

}  // namespace geargraph
