#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <atomic>
#include <functional>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

#include "ui/document/document.h"
#include "ui/service/service.h"

class QProgressDialog;
class QWidget;

namespace geargraph::inline panels {

/// Applies an edit: why the document refused it, as a sentence; empty where it did not.
[[nodiscard]] QString refusalOf(Document& document, const Edit& edit);

/// An edit of many elements, worked out on a thread while the window goes on painting. After a moment a
/// dialog says what is done, how far it is, and can cancel it. When it is ready the document gets it as one
/// edit; where that has changed meanwhile it is worked out again, so that no edit is lost. Its document owns
/// it; it ends with itself.
class LongEdit final : public QObject, public BackgroundWork {
  Q_OBJECT

 public:
  /// How far the work is. Any thread.
  struct Progress {
    std::stop_token stop;
    std::atomic<int>* done;  ///< elements
  };
  /// A pure function, as Reduce. Of no use when a stop was requested meanwhile.
  using Work =
      std::function<Expected<PlacedMechanism>(const PlacedMechanism& before, const Progress& progress)>;

  /// @param elements how many are changed, each of them one of `Progress::done`
  /// @param window the dialog's, which is locked while that is there
  LongEdit(Document* document, QWidget* window, QString text, quint64 gesture, int elements, Work work);
  ~LongEdit() override;

  void tellToEnd() override { m_service->tellToEnd(); }
  [[nodiscard]] bool hasEnded() const override { return m_service->hasEnded(); }

 signals:
  /// Why the document refused it, as a sentence; empty where it did not, or the edit was cancelled.
  void ended(const QString& why);

 private:
  using Result = std::shared_ptr<const Expected<PlacedMechanism>>;

  void begin();
  void take(const Result& result);
  void tell();
  void end(const QString& why = {});

  Document* m_document;
  QWidget* m_window;
  QString m_text;
  quint64 m_gesture;
  int m_elements;
  std::atomic<int> m_done = 0;
  MechanismPtr m_before;  ///< what is being worked on
  QElapsedTimer m_time;
  QTimer m_telling;
  std::unique_ptr<QProgressDialog> m_dialog;
  std::unique_ptr<Service<PlacedMechanism, Result>> m_service;  // last: it ends before what it reads
};

/// The elements changed one after the other, until one is refused or a stop is requested.
template <class Value, class Change>
Expected<Value> changedInTurn(Value before, const std::vector<ElementId>& elements,
                              const LongEdit::Progress& progress, const Change& change) {
  Expected<Value> next = std::move(before);
  for (auto each = elements.begin(); each != elements.end() && next && !progress.stop.stop_requested();
       ++each) {
    next = change(std::move(next).value(), *each);
    ++*progress.done;
  }
  return next;
}

}  // namespace geargraph::inline panels
