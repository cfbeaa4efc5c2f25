#pragma once

#include <QToolBar>
#include <functional>
#include <vector>

#include "core/foundations/base/diagnostic.h"

class QLabel;
class QHBoxLayout;

namespace geargraph::inline mainwindow {

/// Something that the user should decide on, but need not decide now.
struct Notice {
  struct Answer {
    QString text;
    QString tip;
    std::function<void()> run;
  };
  QString key;  ///< a notice takes the place of an older one with its key
  Severity severity = Severity::info;
  QString text;
  std::vector<Answer> answers;  ///< each takes the notice away before it runs
  /// A command of the user was not carried out and waits for the answer: it is shown before all notices that
  /// nobody waits for, which come back after it.
  bool isRequired = false;
};

/// A strip below the tool bar that shows one notice at a time and stops nobody from working: the newest of
/// those that are required, else the oldest.
class NoticeBar : public QToolBar {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  void post(Notice notice);
  /// Another text for a notice that is there; its buttons stay, and what is being pressed with them.
  void setText(const QString& key, const QString& text);
  void withdraw(const QString& key);
  /// The notice that is shown; null where there is none.
  [[nodiscard]] const Notice* current() const { return m_notices.empty() ? nullptr : &m_notices.front(); }
  /// Shown while there is a notice; a restored layout may have said otherwise.
  void renew();

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void renewIcon();
  void fitText();

  std::vector<Notice> m_notices;
  QLabel* m_icon;
  QLabel* m_text;
  QLabel* m_count;
  QHBoxLayout* m_layout;
  QList<QWidget*> m_buttons;
};

}  // namespace geargraph::inline mainwindow
