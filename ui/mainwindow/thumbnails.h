#pragma once

#include <QImage>
#include <QObject>
#include <QSize>

#include "core/mechanism/model/mechanism.h"
#include "core/presentation/drawing/palette.h"

namespace geargraph {

/// Thumbnails of documents for lists. Those of examples are drawn on demand, those of files when the file is
/// opened or saved, and stored in the cache folder, so that showing a list reads no documents. Drawn by the
/// thread pool.
class Thumbnails : public QObject {
  Q_OBJECT

 public:
  static constexpr QSize kSize{208, 130};  ///< pixels of a screen with 96 dots per inch

  explicit Thumbnails(QObject* parent = nullptr) : QObject(parent) {}

  /// Draws the thumbnails of a file, for both themes, and stores them.
  static void keep(const QString& filePath, const MechanismPtr& mechanism);
  /// The stored thumbnail, with twice the resolution of kSize; null if there is none.
  [[nodiscard]] static QImage kept(const QString& filePath, Theme theme);
  /// The path of the stored thumbnail, for the `img` of a tool tip.
  [[nodiscard]] static QString keptPath(const QString& filePath, Theme theme);

  /// Draws asynchronously; drawn() follows, in any order.
  void draw(const QString& path, Theme theme);

 signals:
  void drawn(const QString& path, geargraph::Theme theme, const QImage& picture);
};

}  // namespace geargraph
