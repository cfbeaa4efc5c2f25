#pragma once

#include <QByteArray>
#include <QImage>
#include <QObject>
#include <functional>
#include <memory>
#include <optional>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/mechanism_scene/scene_picture.h"
#include "ui/service/service.h"
#include "ui/view3d/overlay_layer.h"
#include "ui/view3d/view_options.h"

namespace geargraph {

/// Content for the clipboard: elements as JSON, a picture of them, or both.
struct CopiedContent {
  MechanismPtr document;                 ///< which other windows paste; null: none
  bool asText = false;                   ///< its JSON is also the plain text of the clipboard
  std::function<DisplayList()> drawing;  ///< called on another thread; empty: none
  /// The 3D view as shown, with its labels.
  struct Seen {
    SceneRendering rendering;
    ViewOptions options;
    QString forcesCaption;  ///< as forcesCaption()
    PaintOver over;         ///< what is painted over the view; empty: nothing
  };
  std::optional<Seen> seen;
};

/// Puts elements on the clipboard immediately, whose JSON is written on demand, and adds
/// their picture when a thread has painted it: SVG and PNG of a drawing, PNG of the 3D view. Pictures are
/// dark on a transparent background, for paper.
class PictureClipboard : public QObject {
  Q_OBJECT

 public:
  /// Longest side of a PNG of a drawing; an SVG has no pixels.
  static constexpr double kMaxPixels = 4096;

  explicit PictureClipboard(QObject* parent = nullptr);

  void copy(CopiedContent content);
  /// The type of the JSON on the clipboard.
  [[nodiscard]] static QString mimeType();

 signals:
  /// The picture of the newest content is on the clipboard.
  void pictured();
  /// Why there is no picture.
  void rejected(const QString& why);

 private:
  struct Picture {
    CopiedContent content;
    QByteArray svg;
    QByteArray png;
    QImage image;
    QString why;  ///< reason why there is no picture
  };
  using Request = std::shared_ptr<const CopiedContent>;
  using Painter = Service<Request, Picture>;

  static Picture painted(const CopiedContent& content, const std::stop_token& stop);
  void put(const Picture& picture);

  Painter* m_painter;
  bool m_isOurs = false;  ///< the clipboard has what was copied here last
  bool m_isPutting = false;
};

}  // namespace geargraph
