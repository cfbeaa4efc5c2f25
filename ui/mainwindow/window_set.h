#pragma once

#include <QByteArray>
#include <QLockFile>
#include <QObject>
#include <map>
#include <memory>
#include <vector>

#include "ui/recovery/open_documents.h"

class QTimer;

namespace geargraph::inline mainwindow {

class MainWindow;

/// The windows of the program: makes them, sends files to them, and remembers which files were open, so that
/// the next start shows them again.
class WindowSet : public QObject {
  Q_OBJECT

 public:
  /// `folder`: where side files of documents without a file are kept, and the lock of the session. Of several
  /// running programs the first one remembers its windows.
  explicit WindowSet(const QString& folder, QObject* parent = nullptr);
  ~WindowSet() override;

  /// The folder for the running user.
  [[nodiscard]] static QString defaultFolder();

  /// The first windows: these documents, else those of the last session, else the start page; and an offer
  /// for whatever an earlier run left unsaved.
  void start(const QStringList& documents);
  /// A window with an empty document.
  MainWindow& openNew();
  /// Opens a file or example: in its own window if it is open already, in `from` if that holds nothing yet,
  /// else in a new one.
  void open(const QString& path, MainWindow* from);
  /// Closes all windows, unless a person minds, and remembers them.
  void quit();

  [[nodiscard]] bool restoresSession() const;
  void setRestoresSession(bool restores);
  [[nodiscard]] std::vector<MainWindow*> windows() const;
  /// The windows with this file, whatever the spelling of its path, besides one.
  [[nodiscard]] std::vector<MainWindow*> windowsWith(const QString& path,
                                                     const MainWindow* besides = nullptr) const;
  /// To the front, and active as far as the desktop lets a program do that.
  static void bringForward(MainWindow& window);
  /// What all running programs have open.
  [[nodiscard]] OpenDocuments& documents() { return m_documents; }

 private:
  MainWindow& add();
  bool reopenSession();
  void offerLeftBehind();
  void onClosed(MainWindow* window);
  void look();
  void remember();

  struct Layout {
    QByteArray geometry;
    QByteArray state;
  };

  QString m_folder;
  QTimer* m_lookSoon;
  QLockFile m_lock;
  OpenDocuments m_documents;
  bool m_ownsSession;
  bool m_quitting = false;
  std::map<const MainWindow*, Layout> m_layouts;
  std::vector<std::unique_ptr<MainWindow>> m_windows;
};

}  // namespace geargraph::inline mainwindow
