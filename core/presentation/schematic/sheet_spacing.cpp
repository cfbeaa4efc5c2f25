#include "core/presentation/schematic/sheet_spacing.h"

#include <algorithm>

namespace geargraph {
namespace {

constexpr double kBetweenSymbols = 11;
constexpr double kLevel = 4;      ///< between symbols that pass each other across the axes
constexpr double kLeastRoom = 4;  ///< between slots of the same axis

bool shareAxis(const SheetSlot& a, const SheetSlot& b) {
  return std::any_of(a.axes.begin(), a.axes.end(),
                     [&](int axis) { return std::binary_search(b.axes.begin(), b.axes.end(), axis); });
}

/// The least distance of two slots; 0: they need none.
double roomBetween(const SheetSlot& a, const SheetSlot& b) {
  double room = shareAxis(a, b) ? kLeastRoom : 0;
  for (const SheetSpan& left : a.spans) {
    for (const SheetSpan& right : b.spans) {
      const bool isLevel = left.low < right.high + kLevel && right.low < left.high + kLevel;
      if (isLevel) room = std::max(room, left.after + right.before + kBetweenSymbols);
    }
  }
  return room;
}

/// Puts a slot between those before it and the fixed ones behind it on its axes, and leaves a share of that
/// for the others that go there.
void order(std::vector<SheetSlot>& slots, std::size_t i) {
  double low = -1e300;
  for (std::size_t k = 0; k < i; ++k) {
    if (shareAxis(slots[k], slots[i])) low = std::max(low, slots[k].at);
  }
  double high = 1e300;
  int others = 0;
  for (std::size_t k = i + 1; k < slots.size(); ++k) {
    if (!shareAxis(slots[k], slots[i])) continue;
    if (slots[k].fixed) high = std::min(high, *slots[k].fixed);
    others += slots[k].fixed ? 0 : 1;
  }
  const double share = std::min(kLeastRoom, (high - low) / (others + 2));
  slots[i].at = std::max(low + share, std::min(slots[i].at, high - (others + 1) * share));
}

}  // namespace

void packSlots(std::vector<SheetSlot>& slots) {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    double at = i == 0 ? 0 : slots[i - 1].at + 1;
    for (std::size_t k = 0; k < i; ++k)
      at = std::max(at, slots[k].at + std::max(roomBetween(slots[k], slots[i]), kLeastRoom));
    slots[i].at = at;
  }
}

void spreadSlots(std::vector<SheetSlot>& slots) {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    slots[i].at = slots[i].fixed.value_or(slots[i].wanted);
    for (std::size_t k = 0; k < slots.size() && !slots[i].fixed; ++k) {
      const double room = slots[k].fixed ? roomBetween(slots[std::min(i, k)], slots[std::max(i, k)]) : 0;
      if (room > 0)
        slots[i].at = k < i ? std::max(slots[i].at, *slots[k].fixed + room)
                            : std::min(slots[i].at, *slots[k].fixed - room);
    }
  }
  for (std::size_t i = 0; i < slots.size(); ++i) {
    for (std::size_t k = 0; k < i && !slots[i].fixed; ++k) {
      const double room = roomBetween(slots[k], slots[i]);
      if (room > 0) slots[i].at = std::max(slots[i].at, slots[k].at + room);
    }
  }
  for (std::size_t i = slots.size(); i-- > 0;) {
    for (std::size_t k = i + 1; k < slots.size() && !slots[i].fixed; ++k) {
      const double room = roomBetween(slots[i], slots[k]);
      if (room > 0) slots[i].at = std::min(slots[i].at, slots[k].at - room);
    }
  }
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (!slots[i].fixed) order(slots, i);
  }
}

}  // namespace geargraph
