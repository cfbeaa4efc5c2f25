#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/presentation/handout/handout.h"

namespace geargraph {

struct MadeHandoutTrain {
  HandoutTrain train;
  std::vector<std::string> notes;  ///< what is left out or simplified, and why, in sentences
};

/// The train of a handout with its still picture, 720 x 480, which is left out, with a note, if no renderer
/// is available. `folder`: of the document, with the attached 3D files. The result is meaningless if `stop`
/// was requested. Not thread-safe. Cost: that of mechanismScene() and a picture.
[[nodiscard]] MadeHandoutTrain handoutTrain(const AnalysisSnapshot& snapshot,
                                            const std::filesystem::path& folder,
                                            const std::stop_token& stop = {});

}  // namespace geargraph
