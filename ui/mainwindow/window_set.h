#pragma once

#include <QByteArray>
#include <QLockFile>
#include <QObject>
#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/window_files.h"

class QTimer;

namespace geargraph {
struct Lesson;
}  // namespace geargraph

namespace geargraph {

class MainWindow;

/// The windows of the program: creates them, opens files in them, and remembers which files were open for the
/// next start.
class WindowSet : public QObject, public WindowFiles::Windows {
  Q_OBJECT

 public:
  /// @param folder for the side files of documents without a file and for the lock of the session: of several
  /// running instances only the first remembers its windows
  explicit WindowSet(const QString& folder, QObject* parent = nullptr);
  ~WindowSet() override;

  /// The current user's folder.
  [[nodiscard]] static QString defaultFolder();

  /// Opens the first windows: these documents, else those of the last session, else the start page. Offers to
  /// restore what an earlier run left unsaved.
  void start(const QStringList& documents);
  /// Opens a window with an empty document.
  MainWindow& openNew();
  WindowFiles& addWindow() override;
  void openFrom(const QString& path, WindowFiles& from) override;
  [[nodiscard]] std::vector<WindowFiles*> filesWith(const QString& path,
                                                    const WindowFiles* besides) const override;
  [[nodiscard]] OpenDocuments& documents() override { return m_documents; }
  [[nodiscard]] bool restoresSession() const override;
  void setRestoresSession(bool restores) override;
  /// Remembers all windows and closes them, unless the user cancels.
  void quit() override;

  [[nodiscard]] std::vector<MainWindow*> windows() const;

 private:
  MainWindow& add();
  void connectTo(MainWindow& window);
  void chooseLanguage(const QString& code);
  bool reopenSession();
  void offerRecovery();
  void onClosed(MainWindow* window);
  /// Hidden until what works for it has ended, so that nothing waits for that.
  void leave(std::unique_ptr<MainWindow> window);
  void deleteLeft();
  void openLesson(const std::shared_ptr<const Lesson>& lesson, const QString& place, const QString& file);
  void recordLayouts();
  void remember();

  using Layout = Presentation::Layout;

  QString m_folder;
  QTimer* m_recordSoon;
  QLockFile m_lock;
  OpenDocuments m_documents;
  bool m_ownsSession;
  bool m_quitting = false;
  std::map<const MainWindow*, Layout> m_layouts;
  std::vector<std::unique_ptr<MainWindow>> m_windows;
  QTimer* m_leaveSoon;
  /// The first goes first: of two that show one document, the former before the one in its place.
  std::deque<std::unique_ptr<MainWindow>> m_leaving;
};

}  // namespace geargraph
