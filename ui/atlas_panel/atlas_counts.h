#pragma once

#include <QString>

class QWidget;

namespace geargraph {

class ChainCatalogue;

/// Where the counts are from, as a citation.
[[nodiscard]] QString countsSource();
/// What is counted as a chain, and what is left out.
[[nodiscard]] QString countsDefinition();
/// How many chains of one freedom the atlas has, by links, owned by `parent`.
[[nodiscard]] QWidget* countsTable(const ChainCatalogue& catalogue, QWidget* parent);

}  // namespace geargraph
