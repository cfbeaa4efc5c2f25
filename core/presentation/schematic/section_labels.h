#pragma once

#include <string>
#include <vector>

#include "core/presentation/schematic/section.h"

namespace geargraph::inline schematic {

/// The labels of a section: a disc with its number for each link, the numbers of joints and meshes, the names
/// of axes; and under the drawing what its reader has to know. No label lies on a line or another label; one
/// that stands away from what it names has a thin line to it. A drawing too large for a small window has
/// larger labels, so that they can be read when all of it is shown, where these find places.
struct SectionLabels {
  std::vector<Mark> marks;
  std::vector<Outline> outlines;
};

/// `notes`: what stands under the drawing, sectionNotes().
[[nodiscard]] SectionLabels sectionLabels(const DrawnPart& part, const Section& section,
                                          const std::vector<std::string>& notes);

/// What the drawing leaves out or shows otherwise than it is, a sentence each.
[[nodiscard]] std::vector<std::string> sectionNotes(const DrawnPart& part, const SheetLayout& layout);

}  // namespace geargraph::inline schematic
