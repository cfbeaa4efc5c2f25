// soak_gestures [--seed N] --gestures N | --minutes M [DOCUMENT ...]: random gestures on the windows of the
// program. DOCUMENT is the name of an example or "random:LINKS"; by default two examples and trains of 1,000
// and 10,000 links. N gestures are three rounds of every document, all of them with as many; with minutes
// alone, rounds of 200 gestures follow each other until the time is over. Prints what it did and the longest
// stall of each gesture, with --stacks also what it was at, and ends with 1 on a finding.

#include <QApplication>

#include "tests/soak/gesture_soak.h"
#include "tests/soak/live_objects.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/view3d.h"

int main(int argc, char** argv) {
  using namespace geargraph;
  auto options = soak::readOptions(argc, argv, "--gestures");
  if (!options) return 2;
  if (options->documents.empty()) {
    options->documents = {"robot", "random:1000", "eight-speed-gearbox", "random:10000"};
  }
  soak::countObjects();
  View3D::prepareApplication();
  QApplication application(argc, argv);
  return soak::GestureSoak(*options).run() == 0 ? 0 : 1;
}
