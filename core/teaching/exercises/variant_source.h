#pragma once

#include "core/teaching/exercises/exercise_sheet.h"

namespace geargraph {

/// The mechanism of a variant with its results: other numbers of teeth, arrows, and labels of links, joints
/// and meshes, so that no answer can be taken over from a neighbour. A sheet with one variant is about the
/// plan's own mechanism.
///
/// The same plan and variant give the same mechanism. It supports every kind of the plan, has the freedom and
/// rank of the original, and no more errors and warnings; where teeth cannot be changed so (pinned gears, no
/// geometry) they stay. Cost: a few complete analyses without symbols.
/// @pre 1 <= variant; the source supports every kind of the plan
[[nodiscard]] ExerciseSource variantSource(const ExerciseSource& source, const SheetPlan& plan, int variant);

}  // namespace geargraph
