#pragma once

#include <QImage>
#include <memory>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/palette.h"
#include "ui/atlas_panel/chain_catalogue.h"
#include "ui/service/service.h"

namespace geargraph {

/// As what a chain is pictured.
enum class ChainView { digraph, schematic, space };

struct ChainPreviewRequest {
  const AtlasChain* chain = nullptr;
  ChainView view = ChainView::schematic;  ///< the schematic, or in three dimensions
  Theme theme = Theme::light;             ///< of a picture in three dimensions

  friend bool operator==(const ChainPreviewRequest&, const ChainPreviewRequest&) = default;
};

/// The chain as the document that chainDocument() makes of it.
struct ChainPreview {
  ChainPreviewRequest of;
  DisplayList schematic;
  QImage space;  ///< null where nothing can be painted
  QString why;   ///< there is no picture
};
using ChainPreviewPtr = std::shared_ptr<const ChainPreview>;

/// Lays a chain of the program's atlas out and pictures it: tens of milliseconds, in three dimensions more.
class ChainPreviewService final : public Service<ChainPreviewRequest, ChainPreviewPtr> {
 public:
  explicit ChainPreviewService(QObject* parent = nullptr);
};

}  // namespace geargraph
