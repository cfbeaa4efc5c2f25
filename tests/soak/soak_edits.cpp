// soak_edits [--seed N] --edits N | --minutes M: random edits of all kinds, undone, redone, saved, reloaded
// and recovered. Prints what it did and ends with 1 on a finding.

#include <QCoreApplication>

#include "tests/soak/edit_soak.h"

int main(int argc, char** argv) {
  const auto options = geargraph::soak::readOptions(argc, argv, "--edits");
  if (!options) return 2;
  const QCoreApplication application(argc, argv);
  return geargraph::soak::EditSoak(*options).run() == 0 ? 0 : 1;
}
