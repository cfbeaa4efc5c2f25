#pragma once

#include <string>
#include <vector>

#include "core/presentation/schematic/section.h"

namespace geargraph {

/// The labels of a section: a disc with its number for each link, the numbers of joints and meshes, the names
/// of axes; and notes under the drawing. No label overlaps a line or another label; one at a distance from
/// its element has a thin leader line. A large drawing gets larger labels if there is room, so that they are
/// readable when all of it is shown in a small window.
struct SectionLabels {
  std::vector<Mark> marks;
  std::vector<Outline> outlines;
};

/// `notes`: the notes under the drawing, sectionNotes().
[[nodiscard]] SectionLabels sectionLabels(const DrawnPart& part, const Section& section,
                                          const std::vector<std::string>& notes);

/// One sentence for everything that the drawing leaves out or shows differently from the geometry.
[[nodiscard]] std::vector<std::string> sectionNotes(const DrawnPart& part, const SheetLayout& layout);

}  // namespace geargraph
