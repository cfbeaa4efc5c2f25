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

namespace geargraph {

/// Applies an edit. Returns why the document rejected it, as a sentence; empty on success.
[[nodiscard]] QString rejectionOf(Document& document, const Edit& edit);

/// An edit of many elements, computed on a background thread while the window stays responsive. After a short
/// delay a dialog shows the progress and offers to cancel. The result is applied to the document as one edit;
/// if the document has changed meanwhile, the edit is computed again, so that no other edit is lost. Owned by
/// the document; deletes itself when done.
class LongEdit final : public QObject, public BackgroundWork {
  Q_OBJECT

 public:
  /// Progress and cancellation of the work. Thread-safe.
  struct Progress {
    std::stop_token stop;
    std::atomic<int>* done;  ///< number of elements done
  };
  /// A pure function, as Reduce. The result is meaningless if `stop` was requested meanwhile.
  using Work =
      std::function<Expected<PlacedMechanism>(const PlacedMechanism& before, const Progress& progress)>;

  /// @param elements the number of elements to change, the final value of `Progress::done`
  /// @param window the parent of the dialog, blocked while the dialog is shown
  LongEdit(Document* document, QWidget* window, QString text, quint64 gesture, int elements, Work work);
  ~LongEdit() override;

  void requestStop() override { m_service->requestStop(); }
  [[nodiscard]] bool hasStopped() const override { return m_service->hasStopped(); }
  /// Did the user cancel it? Then the work may go on for a while after it has ended.
  [[nodiscard]] bool wasCancelled() const { return m_wasCancelled; }

 signals:
  /// Why the document rejected the edit, as a sentence; empty if it succeeded or was cancelled.
  void ended(const QString& why);

 private:
  using Result = std::shared_ptr<const Expected<PlacedMechanism>>;

  void begin();
  void take(const Result& result);
  void tell();
  void cancel();
  void end(const QString& why);

  Document* m_document;
  QWidget* m_window;
  QString m_text;
  quint64 m_gesture;
  int m_elements;
  bool m_wasCancelled = false;
  std::atomic<int> m_done = 0;
  MechanismPtr m_before;  ///< input of the running computation
  QElapsedTimer m_time;
  QTimer m_telling;
  std::unique_ptr<QProgressDialog> m_dialog;
  std::unique_ptr<Service<PlacedMechanism, Result>> m_service;  // last: uses the members above
};

/// Applies `change` to the elements one after the other, until one is rejected or a stop is requested.
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

}  // namespace geargraph
