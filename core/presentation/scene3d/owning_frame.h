#pragma once

#include <memory>
#include <vector>

#include "core/presentation/scene/renderer.h"
#include "core/presentation/scene3d/stage.h"

namespace geargraph {

/// A frame that owns everything it refers to, including its stage: for a picture that is painted later, on
/// another thread. Cost: O(instances).
class FrameSnapshot {
 public:
  /// `stage` may be null: then the scene is empty.
  FrameSnapshot(MechanismScenePtr stage, const Frame& frame)
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
  FrameSnapshot(const FrameSnapshot&) = delete;
  FrameSnapshot& operator=(const FrameSnapshot&) = delete;

  [[nodiscard]] const MechanismScenePtr& stage() const { return m_stage; }
  [[nodiscard]] const Frame& frame() const { return m_frame; }

 private:
  MechanismScenePtr m_stage;
  std::vector<Pose> m_poses;
  std::vector<Highlight> m_emphasis;
  std::vector<Visibility> m_visibility;
  std::vector<MarkLine> m_marks;
  Frame m_frame;
};

using OwningFramePtr = std::shared_ptr<const FrameSnapshot>;

}  // namespace geargraph
