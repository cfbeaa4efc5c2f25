#include "ui/mainwindow/export_preview_pane.h"

#include <QBoxLayout>
#include <QFontDatabase>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStackedWidget>

#include "ui/models/term_tips.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {

/// A picture, as large as it fits, on the white of the page or of the picture itself.
class PictureBox : public QWidget {
 public:
  using QWidget::QWidget;

  void setImage(const QImage& image) {
    m_image = image;
    update();
  }
  [[nodiscard]] QSize sizeHint() const override { return {320, 240}; }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    if (m_image.isNull()) return;
    QRectF place(QPointF(), QSizeF(m_image.size().scaled(size(), Qt::KeepAspectRatio)));
    const bool isSmaller = m_image.width() < width() && m_image.height() < height();
    if (isSmaller) place.setSize(m_image.size());
    place.moveCenter(QRectF(rect()).center());
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (m_image.hasAlphaChannel()) painter.fillRect(place, Qt::white);
    painter.drawImage(place, m_image);
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(place.adjusted(0, 0, -1, -1));
  }

 private:
  QImage m_image;
};

namespace {

QString sizeOf(qint64 bytes) {
  return QLocale().formattedDataSize(bytes, 1, QLocale::DataSizeSIFormat);
}

}  // namespace

ExportPreviewPane::ExportPreviewPane(QWidget* parent)
    : QWidget(parent),
      m_summary(new QLabel(this)),
      m_notes(new QLabel(this)),
      m_offer(new QPushButton(tr("Show what would be written"), this)),
      m_files(new QListWidget(this)),
      m_content(new QStackedWidget(this)),
      m_text(new QPlainTextEdit(this)),
      m_picture(new PictureBox(this)),
      m_nothing(new QLabel(this)) {
  m_summary->setObjectName(QStringLiteral("exportSummary"));
  m_summary->setWordWrap(true);
  m_notes->setObjectName(QStringLiteral("exportNotes"));
  m_notes->setProperty("look", "hint");
  m_notes->setWordWrap(true);
  m_notes->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_offer->setToolTip(
      tr("Makes the files without keeping them: with a train as large as this it takes a while"));
  m_files->setObjectName(QStringLiteral("exportFiles"));
  m_files->setAccessibleName(tr("Files that would be written"));
  m_text->setObjectName(QStringLiteral("exportText"));
  m_text->setAccessibleName(tr("Beginning of the file"));
  m_text->setReadOnly(true);
  m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
  m_text->setTabChangesFocus(true);
  m_picture->setAccessibleName(tr("Picture of what would be written"));
  m_nothing->setProperty("look", "hint");
  m_nothing->setWordWrap(true);
  m_nothing->setAlignment(Qt::AlignCenter);
  m_content->addWidget(m_nothing);
  m_content->addWidget(m_text);
  m_content->addWidget(m_picture);
  m_content->setMinimumHeight(80);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 0, 0, 0);
  layout->addWidget(m_summary);
  layout->addWidget(m_notes);
  layout->addWidget(m_offer, 0, Qt::AlignLeft);
  layout->addWidget(m_files, 1);
  layout->addWidget(m_content, 3);
  connect(m_files, &QListWidget::currentRowChanged, this, &ExportPreviewPane::showFile);
  connect(m_offer, &QPushButton::clicked, this, &ExportPreviewPane::wanted);
  clear();
}

void ExportPreviewPane::clear() {
  m_preview = {};
  m_files->clear();
  for (QWidget* each : std::initializer_list<QWidget*>{m_notes, m_offer, m_files}) each->hide();
  m_summary->clear();
  showContent({}, {});
}

void ExportPreviewPane::wait() {
  m_offer->hide();
  if (m_preview.files.empty()) m_summary->setText(tr("Working out what would be written…"));
}

void ExportPreviewPane::offer() {
  clear();
  m_offer->show();
}

void ExportPreviewPane::show(const ExportPreview& preview, const Exporter& exporter) {
  m_offer->hide();
  if (!preview.isFinished) {
    m_summary->setText(tr("Working out what would be written: %1 %").arg(qRound(preview.progress * 100)));
    return;
  }
  m_preview = preview;
  m_notes->setText(preview.notes.join(QLatin1Char('\n')));
  m_notes->setVisible(!preview.notes.isEmpty());
  const int count = static_cast<int>(preview.files.size());
  if (!preview.why.isEmpty()) {
    m_summary->clear();
  } else if (preview.isPart) {
    m_summary->setText(tr("Made with all its pictures when it is exported. This is one of them."));
  } else if (count == 1) {
    m_summary->setText(QStringLiteral("%1, %2").arg(preview.files.front().name, sizeOf(preview.bytes())));
  } else {
    m_summary->setText(exporter.files == ExportFiles::folder
                           ? tr("A folder with %1 files, %2").arg(count).arg(sizeOf(preview.bytes()))
                           : tr("%1 files, %2").arg(count).arg(sizeOf(preview.bytes())));
  }
  {
    const QSignalBlocker blocker(m_files);
    m_files->clear();
    for (const PreviewedFile& file : preview.files)
      m_files->addItem(QStringLiteral("%1  (%2)").arg(file.name, sizeOf(file.bytes)));
  }
  m_files->setVisible(count > 1 && !preview.isPart);
  int first = 0;  // that says something
  for (int i = count - 1; i >= 0; --i) {
    const PreviewedFile& file = preview.files[static_cast<std::size_t>(i)];
    if (!file.text.isEmpty() || !file.image.isNull()) first = i;
  }
  m_files->setCurrentRow(first);
  showFile(first);
}

void ExportPreviewPane::showFile(int row) {
  const auto index = static_cast<std::size_t>(row);
  if (row < 0 || index >= m_preview.files.size()) return showContent({}, {});
  const PreviewedFile& file = m_preview.files[index];
  const bool isSaid = !file.text.isEmpty() || !file.image.isNull();
  showContent(isSaid ? file : m_preview.shown, tr("A file for programs: nothing of it is read by people."));
}

void ExportPreviewPane::showContent(const PreviewedFile& file, const QString& nothing) {
  if (!file.image.isNull()) {
    m_picture->setImage(file.image);
    m_content->setCurrentWidget(m_picture);
  } else if (!file.text.isEmpty()) {
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPixelSize(smallPixels());
    m_text->setFont(fixed);
    m_text->setPlainText(file.text);
    m_content->setCurrentWidget(m_text);
  } else {
    m_nothing->setText(nothing);
    m_content->setCurrentWidget(m_nothing);
  }
}

}  // namespace geargraph

#include "moc_export_preview_pane.cpp"
