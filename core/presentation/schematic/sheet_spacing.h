#pragma once

#include <optional>
#include <vector>

namespace geargraph {

/// The extent of a symbol along parallel axes, on either side of its place, and across them; px.
struct SheetSpan {
  double before = 0;
  double after = 0;
  double low = 0;
  double high = 0;
};

/// A place along parallel axes and the symbols there. Slots keep the order of their places, so that the sheet
/// shows the order of the arrangement.
struct SheetSlot {
  double place = 0;             ///< in the machine, along the axes
  double wanted = 0;            ///< preferred place on the sheet, px
  std::optional<double> fixed;  ///< px
  std::vector<SheetSpan> spans;
  std::vector<int> axes;  ///< that the symbols are on, ascending
  double at = 0;          ///< px: the result of the functions below
};

/// Places each slot as near to those before it as its symbols allow. Cost: O(slots^2).
/// @pre ascending places
void packSlots(std::vector<SheetSlot>& slots);

/// Places each slot where it is wanted if there is room, else pushed aside; the order is kept even if fixed
/// slots leave too little room. Cost: O(slots^2).
/// @pre ascending places
void spreadSlots(std::vector<SheetSlot>& slots);

}  // namespace geargraph
