#include "ui/panels/long_edit.h"

#include <QProgressDialog>
#include <QWidget>
#include <utility>

#include "ui/models/term_tips.h"

namespace geargraph {
namespace {

constexpr int kSilence = 400;  // ms, until the dialog comes
constexpr int kTelling = 100;  // ms

}  // namespace

QString rejectionOf(Document& document, const Edit& edit) {
  QString why;
  const auto heard =
      QObject::connect(&document, &Document::rejected, &document,
                       [&why](const Diagnostics& found) { why = shownText(found.front().message); });
  document.apply(edit);
  QObject::disconnect(heard);
  return why;
}

LongEdit::LongEdit(Document* document, QWidget* window, QString text, quint64 gesture, int elements,
                   Work work)
    : QObject(document),
      m_document(document),
      m_window(window),
      m_text(std::move(text)),
      m_gesture(gesture),
      m_elements(elements),
      m_service(std::make_unique<Service<PlacedMechanism, Result>>(
          [this, work = std::move(work)](const PlacedMechanism& before, const auto& respond) {
            Expected<PlacedMechanism> made = work(before, {respond.stop(), &m_done});
            if (!respond.stop().stop_requested())
              respond(std::make_shared<const Expected<PlacedMechanism>>(std::move(made)));
          })) {
  m_service->onAnswer(this, [this](const Result& result) { take(result); });
  connect(&m_telling, &QTimer::timeout, this, &LongEdit::tell);
  // The window and its dialogs may go before the document does.
  connect(window, &QObject::destroyed, this, &LongEdit::cancel);
  m_time.start();
  m_telling.start(kTelling);
  begin();
}

LongEdit::~LongEdit() = default;

void LongEdit::begin() {
  m_done = 0;
  m_before = m_document->mechanism();
  m_service->request(m_document->placed());
}

void LongEdit::take(const Result& result) {
  if (m_document->mechanism() != m_before) return begin();
  m_dialog.reset();
  end(rejectionOf(*m_document, {m_text, [result](const PlacedMechanism&) { return *result; }, m_gesture}));
}

void LongEdit::tell() {
  if (!m_dialog && m_time.elapsed() >= kSilence) {
    m_dialog =
        std::make_unique<QProgressDialog>(tr("%1 …").arg(m_text), tr("Cancel"), 0, m_elements, m_window);
    m_dialog->setObjectName(QStringLiteral("longEdit"));
    m_dialog->setWindowModality(Qt::WindowModal);
    m_dialog->setAutoClose(false);
    m_dialog->setAutoReset(false);
    connect(m_dialog.get(), &QProgressDialog::canceled, this, &LongEdit::cancel);
    m_dialog->show();
  }
  if (m_dialog) m_dialog->setValue(m_done);
}

void LongEdit::cancel() {
  m_wasCancelled = true;
  end({});
}

void LongEdit::end(const QString& why) {
  m_telling.stop();
  m_service->cancel();
  disconnect(m_window, nullptr, this, nullptr);
  if (m_dialog) m_dialog.release()->deleteLater();  // it may be the one that was cancelled
  emit ended(why);
  deleteLater();
}

}  // namespace geargraph

#include "moc_long_edit.cpp"
