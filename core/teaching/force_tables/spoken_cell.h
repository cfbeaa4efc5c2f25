#pragma once

#include "core/foundations/base/locale.h"
#include "core/foundations/base/translation.h"
#include "core/teaching/force_tables/force_table.h"

namespace geargraph {

/// A cell with the text that `compose` returns, in the current language, and in English for files.
template <class Compose>
ForceCell spokenCell(const Compose& compose) {
  ForceCell cell{compose(), std::nullopt, {}};
  const EnglishScope english;
  cell.textInFiles = compose();
  return cell;
}

/// A column with the head that `compose` returns, likewise.
template <class Compose>
ForceColumn spokenColumn(const Compose& compose, std::string unit, std::string meaning, bool isNumber,
                         bool isFraction = false) {
  ForceColumn column{compose(), std::move(unit), std::move(meaning), isNumber, isFraction};
  const EnglishScope english;
  column.headInFiles = compose();
  return column;
}

/// A column whose head and meaning are marked by toTranslate().
inline ForceColumn wordedColumn(const char* head, std::string unit, const char* meaning, bool isNumber,
                                bool isFraction = false) {
  return spokenColumn([head] { return translated(head); }, std::move(unit), translated(meaning), isNumber,
                      isFraction);
}

}  // namespace geargraph
