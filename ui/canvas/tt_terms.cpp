#include "ui/canvas/tt_terms.h"

#include <QCoreApplication>

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("canvas", text);
}

QString tip(const QString& name, const QString& text) {
  return QStringLiteral("<p style='white-space:normal'><b>%1</b><br>%2</p>").arg(name, text);
}

}  // namespace

QString tipOf(TtTerm term) {
  switch (term) {
    case TtTerm::graph:
      return tip(tr("T–T graph"),
                 tr("The mechanism after Tsai and Tokad: a node for each link, a branch of the tree for each "
                    "turning joint with the level it turns on, and for each gear mesh two chords, from its "
                    "gears to their carrier arm. An arrow from i to k carries ω<sub>ik</sub>, the velocity "
                    "of link i relative to link k."));
    case TtTerm::level:
      return tip(tr("Level"), tr("The axis that a branch turns about: a, b, c … Joints that stay coaxial in "
                                 "every motion are on one level."));
    case TtTerm::transferVertex:
      return tip(tr("Transfer vertex"),
                 tr("The carrier arm of a gear mesh: the node on the walk from gear to gear through the tree "
                    "where the level changes."));
    case TtTerm::chord:
      return tip(tr("Chord"),
                 tr("A thin line from a gear of a mesh to its transfer vertex. The two chords of a mesh bear "
                    "the same number of primes. Chords are no part of the tree: each closes one f-circuit."));
    case TtTerm::terminalEquation:
      return tip(tr("Terminal equation"),
                 tr("What the teeth say about the two chords of a mesh: ω<sub>ik</sub> = ± "
                    "(N<sub>j</sub> / N<sub>i</sub>) ω<sub>jk</sub>, plus where both gears turn the same "
                    "way, seen from the carrier arm. Eq. (26)"));
    case TtTerm::fundamentalCircuit:
      return tip(tr("f-circuit"),
                 tr("A chord and the branches between its two ends: the velocity of the chord is the sum of "
                    "theirs, with signs by their direction. Eqs. (31)–(38)"));
  }
  return {};
}

}  // namespace geargraph
