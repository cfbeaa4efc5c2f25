#include "ui/view3d/scene_accessible.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QPointer>
#include <algorithm>
#include <map>

#include "ui/view3d/view3d.h"

namespace geargraph {
namespace {

const QString kCanvas = QStringLiteral("view3dCanvas");

QWidget* canvasOf(const View3D& view) {
  return view.findChild<QWidget*>(kCanvas, Qt::FindDirectChildrenOnly);
}

class LinkAccessible final : public QAccessibleInterface, public QAccessibleActionInterface {
 public:
  LinkAccessible(View3D* view, const ElementId& link) : m_view(view), m_link(link) {}

  [[nodiscard]] bool isValid() const override {
    if (!m_view || !m_view->stage()) return false;
    const auto shown = m_view->shownLinks();
    return std::find(shown.begin(), shown.end(), m_link) != shown.end();
  }
  [[nodiscard]] QObject* object() const override { return nullptr; }
  [[nodiscard]] QWindow* window() const override {
    return m_view ? m_view->window()->windowHandle() : nullptr;
  }
  [[nodiscard]] QAccessibleInterface* parent() const override {
    return m_view ? QAccessible::queryAccessibleInterface(canvasOf(*m_view)) : nullptr;
  }
  [[nodiscard]] QAccessibleInterface* child(int) const override { return nullptr; }
  [[nodiscard]] QAccessibleInterface* childAt(int, int) const override { return nullptr; }
  [[nodiscard]] int childCount() const override { return 0; }
  [[nodiscard]] int indexOfChild(const QAccessibleInterface*) const override { return -1; }

  [[nodiscard]] QString text(QAccessible::Text what) const override {
    return what == QAccessible::Name && isValid() ? m_view->nameOf(m_link) : QString();
  }
  void setText(QAccessible::Text, const QString&) override {}
  [[nodiscard]] QRect rect() const override {
    if (!m_view) return {};
    const QWidget* canvas = canvasOf(*m_view);
    return {canvas->mapToGlobal(QPoint()), canvas->size()};
  }
  [[nodiscard]] QAccessible::Role role() const override { return QAccessible::Graphic; }
  [[nodiscard]] QAccessible::State state() const override {
    QAccessible::State state;
    state.invalid = !isValid();
    state.selectable = state.focusable = true;
    state.selected = m_view && m_view->isSelected(m_link);
    state.focused = state.selected && m_view->hasFocus();
    return state;
  }

  void* interface_cast(QAccessible::InterfaceType type) override {
    return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface*>(this) : nullptr;
  }
  [[nodiscard]] QStringList actionNames() const override { return {pressAction()}; }
  void doAction(const QString& action) override {
    if (isValid() && action == pressAction()) m_view->select(m_link);
  }
  [[nodiscard]] QStringList keyBindingsForAction(const QString&) const override { return {}; }

 private:
  QPointer<View3D> m_view;
  ElementId m_link;
};

class CanvasAccessible final : public QAccessibleWidget {
 public:
  CanvasAccessible(QWidget* canvas, View3D* view)
      : QAccessibleWidget(canvas, QAccessible::Canvas, View3D::tr("Picture of the train")), m_view(view) {}
  ~CanvasAccessible() override {
    for (const auto& [link, id] : m_ids) QAccessible::deleteAccessibleInterface(id);
  }
  CanvasAccessible(const CanvasAccessible&) = delete;
  CanvasAccessible& operator=(const CanvasAccessible&) = delete;

  [[nodiscard]] int childCount() const override { return static_cast<int>(m_view->shownLinks().size()); }
  [[nodiscard]] QAccessibleInterface* child(int index) const override {
    const auto links = m_view->shownLinks();
    if (index < 0 || static_cast<std::size_t>(index) >= links.size()) return nullptr;
    return accessibleOf(links[static_cast<std::size_t>(index)]);
  }
  [[nodiscard]] int indexOfChild(const QAccessibleInterface* child) const override {
    for (int i = 0; i < childCount(); ++i) {
      if (this->child(i) == child) return i;
    }
    return -1;
  }
  [[nodiscard]] QAccessibleInterface* childAt(int, int) const override { return nullptr; }
  [[nodiscard]] QAccessibleInterface* accessibleOf(const ElementId& link) const {
    auto found = m_ids.find(link);
    if (found == m_ids.end()) {
      const auto id = QAccessible::registerAccessibleInterface(new LinkAccessible(m_view, link));
      found = m_ids.emplace(link, id).first;
    }
    return QAccessible::accessibleInterface(found->second);
  }

 private:
  View3D* m_view;
  mutable std::map<ElementId, QAccessible::Id> m_ids;
};

QAccessibleInterface* canvasAccessible(const QString&, QObject* object) {
  auto* canvas = qobject_cast<QWidget*>(object);
  if (canvas == nullptr || canvas->objectName() != kCanvas) return nullptr;
  auto* view = qobject_cast<View3D*>(canvas->parentWidget());
  return view != nullptr ? new CanvasAccessible(canvas, view) : nullptr;
}

}  // namespace

void installStageAccessibility() {
  static const bool once = [] {
    QAccessible::installFactory(&canvasAccessible);
    return true;
  }();
  Q_UNUSED(once)
}

}  // namespace geargraph
