#include "ui/mainwindow/picture_clipboard.h"

#include <QApplication>
#include <QClipboard>
#include <QMimeData>
#include <algorithm>
#include <utility>

#include "core/mechanism/document_format/mechanism_file.h"
#include "core/presentation/cairo_output/picture.h"
#include "ui/view3d/overlay.h"

namespace geargraph {
namespace {

QByteArray bytesOf(const Expected<std::string>& file) {
  return file ? QByteArray::fromStdString(*file) : QByteArray();
}

SheetStyle paperStyle() {
  SheetStyle style;
  style.transparent = true;
  return style;
}

/// A document as JSON, written on demand: that of 10,000 links takes 20 ms, and is seldom
/// pasted.
class WrittenWhenAsked final : public QMimeData {
 public:
  WrittenWhenAsked(MechanismPtr document, bool asText) : m_document(std::move(document)) {
    setData(PictureClipboard::mimeType(), {});
    if (asText) setText(QString());
  }

 protected:
  [[nodiscard]] QVariant retrieveData(const QString& format, QMetaType type) const override {
    const bool isText = format == QLatin1String("text/plain");
    if (!isText && format != PictureClipboard::mimeType()) return QMimeData::retrieveData(format, type);
    if (m_json.isEmpty()) m_json = QByteArray::fromStdString(writeMechanism(*m_document));
    return isText ? QVariant(QString::fromUtf8(m_json)) : QVariant(m_json);
  }

 private:
  MechanismPtr m_document;
  mutable QByteArray m_json;
};

/// Twice the size of the screen, unless that is more than a picture may have.
double scaleOf(const DisplayList& drawing) {
  const Extent sheet = sheetOf(drawing, paperStyle());
  constexpr double kScale = 2;
  return std::min(kScale, PictureClipboard::kMaxPixels / (2 * std::max(sheet.halfWidth, sheet.halfHeight)));
}

}  // namespace

QString PictureClipboard::mimeType() {
  return QStringLiteral("application/x-geargraph+json");
}

PictureClipboard::PictureClipboard(QObject* parent)
    : QObject(parent),
      m_painter(
          new Painter([](const Request& request,
                         const Painter::Responder& respond) { respond(painted(*request, respond.stop())); },
                      this)) {
  connect(QApplication::clipboard(), &QClipboard::dataChanged, this, [this] {
    if (!m_isPutting) m_isOurs = false;
  });
  m_painter->onAnswer(this, [this](const Picture& picture) {
    if (!m_isOurs) return;  // something else has been copied meanwhile
    if (!picture.why.isEmpty()) return emit rejected(picture.why);
    if (picture.png.isEmpty()) return;
    put(picture);
    emit pictured();
  });
}

void PictureClipboard::copy(CopiedContent content) {
  if (content.document) put({content, {}, {}, {}, {}});
  m_isOurs = true;
  if (!content.drawing && !content.seen) return m_painter->cancel();
  m_painter->request(std::make_shared<const CopiedContent>(std::move(content)));
}

PictureClipboard::Picture PictureClipboard::painted(const CopiedContent& content,
                                                    const std::stop_token& stop) {
  Picture picture{content, {}, {}, {}, {}};
  if (content.seen) {
    Expected<std::unique_ptr<ScenePainter>> painter = ScenePainter::create(content.seen->rendering, stop);
    if (!painter) {
      picture.why = QString::fromStdString(painter.error().front().message);
      return picture;
    }
    if (*painter == nullptr) return picture;  // stopped
    Image image = (*painter)->paint(0);
    PictureOverlay overlay(content.seen->options, false);
    const VisibilityBuffer seen = (*painter)->seenForLabels();
    if (image.width > 0) {
      const SeenStage& shown = (*painter)->seen();
      const ShownForces forces{shown.view().forces,
                               shown.forceArrows(),
                               {},
                               content.seen->forcesCaption,
                               static_cast<bool>(content.seen->over)};
      overlay.paint(image, (*painter)->labelGround(seen), forces);
      paintLayer(image, (*painter)->labelGround(seen), shown.view(), content.seen->over, false, forces);
    }
    const auto bytes = pngBytes(image, stop);
    picture.png =
        QByteArray(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
  } else {
    const DisplayList drawing = content.drawing();
    if (drawing.marks.empty()) return picture;  // the drawing in front does not show what was copied
    DrawingPicture how;
    how.style = paperStyle();
    picture.svg = bytesOf(pictureOf(drawing, how));
    how.form = PictureForm::png;
    how.scale = scaleOf(drawing);
    picture.png = bytesOf(pictureOf(drawing, how));
  }
  if (stop.stop_requested()) return picture;
  if (picture.png.isEmpty()) picture.why = tr("There is not enough memory for the picture.");
  picture.image = QImage::fromData(picture.png, "PNG");
  return picture;
}

void PictureClipboard::put(const Picture& picture) {
  const CopiedContent& content = picture.content;
  auto* data = content.document ? new WrittenWhenAsked(content.document, content.asText) : new QMimeData;
  if (!picture.svg.isEmpty()) data->setData(QStringLiteral("image/svg+xml"), picture.svg);
  if (!picture.png.isEmpty()) data->setData(QStringLiteral("image/png"), picture.png);
  if (!picture.image.isNull()) data->setImageData(picture.image);
  m_isPutting = true;
  QApplication::clipboard()->setMimeData(data);
  m_isPutting = false;
}

}  // namespace geargraph

#include "moc_picture_clipboard.cpp"
