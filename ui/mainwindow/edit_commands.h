#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <set>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"
#include "core/presentation/drawing/display_list.h"

namespace geargraph {
class Document;
}  // namespace geargraph
namespace geargraph {
class Selection;
}  // namespace geargraph
namespace geargraph {
class Workbench;
}  // namespace geargraph

namespace geargraph {

class PictureClipboard;

/// Commands that edit the selection, independent of the view. The clipboard gets a document in JSON, for
/// other windows, programs and text editors, and a picture of what was copied.
class EditCommands : public QObject {
  Q_OBJECT

 public:
  /// Returns what makes the picture of the drawing in front as it is then, on any thread.
  using PictureOf = std::function<std::function<DisplayList()>()>;
  EditCommands(Workbench& workbench, PictureClipboard* clipboard, PictureOf picture, QWidget* window);

  bool copy();  ///< false if nothing selected can be copied
  void cut();
  void paste();
  void duplicate();
  /// For the first selected link: makes it the ground; copies it to `total` equally spaced planets.
  void makeGround();
  void makePlanets(int total);
  void insertSet(const Mechanism& set);

 signals:
  void rejected(const QString& why);
  void noted(const QString& note);

 private:
  void insert(const Mechanism& fragment, const QString& text);
  /// `read` makes the fragment, on the other thread.
  void insertInBackground(std::function<Expected<Mechanism>()> read, const QString& text);
  void inserted(const std::set<ElementId>& added, const std::string& unit);

  QWidget* m_window;
  Document* m_document;
  Selection* m_selection;
  PictureClipboard* m_clipboard;
  PictureOf m_picture;
};

}  // namespace geargraph
