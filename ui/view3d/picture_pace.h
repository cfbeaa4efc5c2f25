#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "ui/view3d/label_layer.h"
#include "ui/view3d/viewer.h"

namespace geargraph {

/// Decides how expensive the next frame may be. In software rendering, frames are drafts while the picture
/// moves; antialiasing and shadows are added once it rests. While it moves, labels move with their parts; the
/// map of visible parts is made only now and then, and once more when the picture has come to rest.
class PicturePace : public QObject {
  Q_OBJECT

 public:
  PicturePace(const Viewer* viewer, const LabelLayer* labels, QObject* parent);

  void setSoftware(bool software) { m_isSoftware = software; }
  /// Is the next frame a draft?
  [[nodiscard]] bool isDraft() const { return m_isSoftware && !m_isStill; }
  /// Reports that a draft frame is shown: the rest begins now, because with slow frames a full frame between
  /// two drafts of a movement would only delay the next.
  void shown();
  /// Is a map of visible parts to be made with the frame rendered now? If so, it is taken as made.
  [[nodiscard]] bool takeMap();

 signals:
  void rested();  ///< a full frame is due

 private:
  void onMoving(int stillAfter);

  const LabelLayer* m_labels;
  bool m_isSoftware = false;
  bool m_isStill = true;    ///< nothing has changed for a while: full frames are allowed
  bool m_mapIsOld = false;  ///< labels are placed by the map of an earlier frame
  QTimer m_whenStill;
  QElapsedTimer m_sinceMap;
  QElapsedTimer m_sinceScene;
};

}  // namespace geargraph
