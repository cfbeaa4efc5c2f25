#include "ui/atlas_panel/chain_preview.h"

#include "core/design/atlas/chain_document.h"
#include "core/presentation/mechanism_scene/mechanism_scene.h"
#include "core/presentation/mechanism_scene/scene_picture.h"
#include "core/presentation/schematic/schematic.h"
#include "core/theory/analysis/analysis.h"
#include "ui/models/term_tips.h"

namespace geargraph {
namespace {

constexpr Viewport kSpaceSize{480, 400};

void pictureSpace(ChainPreview& preview, const Mechanism& document, const std::stop_token& stop) {
  const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(document));
  GearCache cache;
  SceneRendering rendering;
  rendering.stage = mechanismScene(*snapshot, cache, nullptr, nullptr, stop);
  if (!rendering.stage || stop.stop_requested()) return;
  rendering.size = kSpaceSize;
  rendering.view.style = pictureStyle(preview.of.theme, true);
  const Expected<Image> picture = stagePicture(std::move(rendering));
  if (!picture) {
    preview.why = shownText(picture.error().front().message);
    return;
  }
  const std::vector<std::uint8_t> png = pngBytes(*picture, stop);
  preview.space = QImage::fromData(png.data(), static_cast<int>(png.size()), "PNG");
}

void answerPreview(const ChainPreviewRequest& request, const ChainPreviewService::Responder& respond) {
  auto preview = std::make_shared<ChainPreview>();
  preview->of = request;
  const AtlasChain& chain = *request.chain;
  const Mechanism document = chainDocument(chain.chain, chain.number.toString(), {}, respond.stop());
  if (respond.stop().stop_requested()) return;
  if (request.view == ChainView::schematic) {
    preview->schematic = schematicDrawing(schematicGeometry(document, respond.stop()), {});
  } else {
    pictureSpace(*preview, document, respond.stop());
  }
  if (!respond.stop().stop_requested()) respond(std::move(preview));
}

bool isSamePreview(const ChainPreviewRequest& before, const ChainPreviewRequest& now) {
  return before == now;
}

}  // namespace

ChainPreviewService::ChainPreviewService(QObject* parent)
    : Service(answerPreview, parent, {.same = &isSamePreview}) {}

}  // namespace geargraph
