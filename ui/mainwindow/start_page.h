#pragma once

#include <QWidget>

class QLabel;
class QListView;
class QStandardItemModel;
class QTabBar;

namespace geargraph {

class Thumbnails;

/// The page of a window without a document: new, open, recent files and examples, with pictures. It covers
/// drawings and docks, below the tool bars, without changing them.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  /// @pre parent is a QMainWindow
  explicit StartPage(QWidget* parent);

  /// Refills the lists and shows the page. `withRecent`: with recent files.
  void open(bool withRecent);
  /// Hides the page and gives the focus to `below`.
  void dismiss(QWidget* below);

  [[nodiscard]] QListView& examples() { return *m_examples; }
  [[nodiscard]] QListView& recent() { return *m_recent; }

 signals:
  void newWanted();
  void openWanted();
  /// The gearbox designer.
  void designWanted();
  void chosen(const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  QWidget* makeSide();
  QWidget* makeExamples();
  QListView* makeList(const char* name, QStandardItemModel* model);
  void fill();
  void addExample(const QString& path, int group);
  /// Hides the examples of other groups; 0 shows all.
  void showGroup(int group);
  void fillRecent();
  void fitWindow();

  Thumbnails* m_thumbnails;
  QStandardItemModel* m_recentModel;
  QStandardItemModel* m_exampleModel;
  QListView* m_recent;
  QListView* m_examples;
  QTabBar* m_groups;
  QLabel* m_noRecent;
  bool m_withRecent = true;
};

}  // namespace geargraph
