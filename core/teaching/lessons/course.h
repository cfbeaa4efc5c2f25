#pragma once

#include <vector>

#include "core/teaching/lessons/prepared_step.h"

namespace geargraph::inline lessons {

/// The lessons that the program brings, in the order in which they are taught. Read once, from any thread.
[[nodiscard]] const std::vector<Lesson>& course();

/// The examples that the program brings, by the names of their files: "robot".
[[nodiscard]] Expected<MechanismPtr> bundledExample(const std::string& name);

}  // namespace geargraph::inline lessons
