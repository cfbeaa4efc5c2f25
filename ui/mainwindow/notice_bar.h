#pragma once

#include <QToolBar>
#include <functional>
#include <vector>

#include "core/foundations/base/diagnostic.h"

class QLabel;
class QHBoxLayout;

namespace geargraph {

/// A notice that asks for a decision without interrupting the user.
struct Notice {
  struct Answer {
    QString text;
    QString tip;
    std::function<void()> run;
  };
  QString key;  ///< a notice replaces an older one with the same key
  Severity severity = Severity::info;
  QString text;
  std::vector<Answer> answers;  ///< each removes the notice before it runs
  /// A command of the user waits for the answer: it is shown before all other notices, which reappear after
  /// it.
  bool isRequired = false;
  /// Tells what a command has just done: shown before all notices that are not required.
  bool isNews = false;
};

/// A strip below the tool bar that shows one notice at a time without blocking the window: the newest
/// required one, else the newest news, else the oldest.
class NoticeBar : public QToolBar {
  Q_OBJECT

 public:
  explicit NoticeBar(QWidget* parent = nullptr);

  void post(Notice notice);
  /// Changes the text of a notice; its buttons stay, even while pressed.
  void setText(const QString& key, const QString& text);
  void withdraw(const QString& key);
  /// The shown notice; null if there is none.
  [[nodiscard]] const Notice* current() const { return m_notices.empty() ? nullptr : &m_notices.front(); }
  /// Restores the visibility, which a restored layout may have changed: visible while there is a notice.
  void renew();

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void updateIcon();
  void fitText();

  std::vector<Notice> m_notices;
  QLabel* m_icon;
  QLabel* m_text;
  QLabel* m_count;
  QHBoxLayout* m_layout;
  QList<QWidget*> m_buttons;
};

}  // namespace geargraph
