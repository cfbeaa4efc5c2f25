#pragma once

#include <memory>
#include <vector>

#include "core/presentation/painting/renderer.h"
#include "core/presentation/stage/stage.h"

namespace geargraph::inline stage {

/// A frame that owns everything it refers to, including its stage: for a picture that is painted later, on
/// another thread. Cost: O(instances).
class OwningFrame {
 public:
  /// `stage` may be null: then the scene is empty.
  OwningFrame(StagePtr stage, const Frame& frame)
      : m_stage(std::move(stage)),
        m_poses(frame.poses.begin(), frame.poses.end()),
        m_emphasis(frame.emphasis.begin(), frame.emphasis.end()),
        m_visibility(frame.visibility.begin(), frame.visibility.end()),
        m_marks(frame.marks.begin(), frame.marks.end()),
        m_frame(frame) {
    m_frame.poses = m_poses;
    m_frame.emphasis = m_emphasis;
    m_frame.visibility = m_visibility;
    m_frame.marks = m_marks;
  }
  OwningFrame(const OwningFrame&) = delete;
  OwningFrame& operator=(const OwningFrame&) = delete;

  [[nodiscard]] const StagePtr& stage() const { return m_stage; }
  [[nodiscard]] const Frame& frame() const { return m_frame; }

 private:
  StagePtr m_stage;
  std::vector<Pose> m_poses;
  std::vector<Highlight> m_emphasis;
  std::vector<Visibility> m_visibility;
  std::vector<MarkLine> m_marks;
  Frame m_frame;
};

using OwningFramePtr = std::shared_ptr<const OwningFrame>;

}  // namespace geargraph::inline stage
