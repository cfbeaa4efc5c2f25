#include "tests/soak/live_objects.h"

#include <QObject>
#include <atomic>

// Declared in a private header of Qt's; the layout is fixed, debuggers read it.
extern quintptr Q_DECL_IMPORT qtHookData[];

namespace geargraph::soak {
namespace {

constexpr int kAddObject = 3;
constexpr int kRemoveObject = 4;

std::atomic<long> objects{0};

void added(QObject* /*object*/) {
  ++objects;
}

void removed(QObject* /*object*/) {
  --objects;
}

}  // namespace

void countObjects() {
  qtHookData[kAddObject] = reinterpret_cast<quintptr>(&added);
  qtHookData[kRemoveObject] = reinterpret_cast<quintptr>(&removed);
}

long liveObjects() {
  return objects;
}

}  // namespace geargraph::soak
