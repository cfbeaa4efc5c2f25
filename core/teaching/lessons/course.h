#pragma once

#include <vector>

#include "core/teaching/lessons/prepared_step.h"

namespace geargraph {

/// The bundled lessons, in teaching order. Parsed on first use; thread-safe.
[[nodiscard]] const std::vector<Lesson>& course();

/// A bundled example, by the name of its file: "robot".
[[nodiscard]] Expected<MechanismPtr> bundledExample(const std::string& name);

}  // namespace geargraph
