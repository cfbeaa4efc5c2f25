#include "ui/atlas_panel/atlas_counts.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QWidget>

#include "ui/atlas_panel/chain_catalogue.h"

namespace geargraph {

QString countsSource() {
  return QWidget::tr("Counts for 1 freedom as in Yang, Ding et al., J. Mech. Des. 141(4), 2019, 043301");
}

QString countsDefinition() {
  return QWidget::tr(
      "A chain is links, axes and gear pairs, each pair with the link that carries both gears. Which link is "
      "held, teeth, kinds of gears and the joints by which coaxial links are drawn do not matter. Equations: "
      "the triples gear, gear, carrier alone (rotation graphs), which are the equations of the speeds. "
      "Chains: "
      "with the axes, too (displacement graphs). Left out are chains in which m gear pairs have fewer than "
      "m + 2 links between them, so that these turn as one; the smallest of them are the trains that cannot "
      "turn.");
}

QWidget* countsTable(const ChainCatalogue& catalogue, QWidget* parent) {
  auto* table = new QWidget(parent);
  auto* layout = new QGridLayout(table);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setVerticalSpacing(2);
  const auto put = [table, layout](int row, int column, const QString& text, bool isHead) {
    auto* label = new QLabel(text, table);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    if (isHead) label->setProperty("look", "hint");
    layout->addWidget(label, row, column);
  };
  put(0, 0, QWidget::tr("links"), true);
  put(0, 1, QWidget::tr("equations"), true);
  put(0, 2, QWidget::tr("chains"), true);
  const Atlas& atlas = catalogue.atlas();
  for (int links = 3; links <= atlas.mostLinks(1); ++links) {
    const ChainCounts counts = countsOf(atlas.chains(links, 1));
    put(links - 2, 0, QString::number(links), false);
    put(links - 2, 1, table->locale().toString(counts.rotations), false);
    put(links - 2, 2, table->locale().toString(counts.displacements), false);
  }
  return table;
}

}  // namespace geargraph
