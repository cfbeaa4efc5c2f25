#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "ui/view3d/label_layer.h"
#include "ui/view3d/viewer.h"

namespace geargraph::inline view3d {

/// How much a picture may cost at the moment. Where the processor paints, a quick look does while the picture
/// moves: antialiasing and shadow come as soon as it rests. And while it moves, labels go with their parts;
/// where these are seen is looked at now and then only, and once more when the picture has come to rest.
class PicturePace : public QObject {
  Q_OBJECT

 public:
  PicturePace(const Viewer* viewer, const LabelLayer* labels, QObject* parent);

  void setSoftware(bool software) { m_isSoftware = software; }
  /// The picture of the moment is a quick look.
  [[nodiscard]] bool isQuick() const { return m_isSoftware && !m_isStill; }
  /// A quick look is on the screen now: it rests from here on. Where pictures are slow, a better one between
  /// two of a movement would only hold up the next.
  void shown();
  /// Is a map of what is seen to be made with the picture that is painted now? If so, it counts as made.
  [[nodiscard]] bool takeMap();

 signals:
  void rested();  ///< a better picture is due

 private:
  void onMoving(int stillAfter);

  const LabelLayer* m_labels;
  bool m_isSoftware = false;
  bool m_isStill = true;    ///< nothing has changed for a while: the picture may cost more
  bool m_mapIsOld = false;  ///< labels stand by an earlier picture's map
  QTimer m_whenStill;
  QElapsedTimer m_sinceMap;
  QElapsedTimer m_sinceScene;
};

}  // namespace geargraph::inline view3d
