#pragma once

#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/drawing/display_list.h"

namespace geargraph {

/// More links than these have no room for names: such a drawing has no captions.
constexpr int kMaxCaptionedLinks = 120;

/// The names of links and the teeth of meshes for a drawing of the mechanism (digraph, T-T graph or
/// schematic), as marks in addition to its own: a name beside the disc of its link, "z 20 : 30" (tail and
/// head) beside the number of its mesh, or "z 20" and "z 30" where the mesh has two labels, as in the T-T
/// graph. A caption touches no line, node, label or other caption; one without a free place beside its label
/// is left out. The marks of the drawing stay where they are.
///
/// `nameSize`: px of a name's em; 0: that of the link's number.
/// Cost: near linear in the marks.
[[nodiscard]] std::vector<Mark> captionsOf(const DisplayList& drawing, const Mechanism& mechanism,
                                           double nameSize = 0);

/// px of names in the digraph and the T-T graph.
constexpr double kGraphNameSize = 11;

/// The drawing with its captions, in painting order.
[[nodiscard]] DisplayList withCaptions(DisplayList drawing, const Mechanism& mechanism, double nameSize = 0);

}  // namespace geargraph
