#include "ui/canvas/drawing_accessible.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QPointer>
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "ui/canvas/drawing_view.h"

namespace geargraph {
namespace {

class ElementAccessible final : public QAccessibleInterface, public QAccessibleActionInterface {
 public:
  ElementAccessible(DrawingView* view, const ElementId& element) : m_view(view), m_element(element) {}

  [[nodiscard]] bool isValid() const override {
    return m_view != nullptr && !m_view->boxOf(m_element).isNull();
  }
  [[nodiscard]] QObject* object() const override { return nullptr; }
  [[nodiscard]] QWindow* window() const override {
    return m_view ? m_view->window()->windowHandle() : nullptr;
  }
  [[nodiscard]] QAccessibleInterface* parent() const override {
    return QAccessible::queryAccessibleInterface(m_view);
  }
  [[nodiscard]] QAccessibleInterface* child(int) const override { return nullptr; }
  [[nodiscard]] QAccessibleInterface* childAt(int, int) const override { return nullptr; }
  [[nodiscard]] int childCount() const override { return 0; }
  [[nodiscard]] int indexOfChild(const QAccessibleInterface*) const override { return -1; }

  [[nodiscard]] QString text(QAccessible::Text what) const override {
    return m_view && what == QAccessible::Name ? m_view->describe(m_element) : QString();
  }
  void setText(QAccessible::Text, const QString&) override {}
  [[nodiscard]] QRect rect() const override {
    if (!m_view) return {};
    const QRect box = m_view->boxOf(m_element);
    return {m_view->viewport()->mapToGlobal(box.topLeft()), box.size()};
  }
  [[nodiscard]] QAccessible::Role role() const override { return QAccessible::Graphic; }
  [[nodiscard]] QAccessible::State state() const override {
    QAccessible::State state;
    if (!m_view) {
      state.invalid = true;
      return state;
    }
    state.selectable = state.focusable = true;
    state.selected = m_view->isSelected(m_element);
    state.focused = m_view->hasFocus() && m_view->currentElement() == std::optional(m_element);
    state.offscreen = !m_view->viewport()->rect().intersects(m_view->boxOf(m_element));
    return state;
  }

  void* interface_cast(QAccessible::InterfaceType type) override {
    return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface*>(this) : nullptr;
  }
  [[nodiscard]] QStringList actionNames() const override { return {pressAction()}; }
  void doAction(const QString& action) override {
    if (m_view && action == pressAction()) m_view->walkTo(m_element);
  }
  [[nodiscard]] QStringList keyBindingsForAction(const QString&) const override { return {}; }

 private:
  QPointer<DrawingView> m_view;
  ElementId m_element;
};

/// A drawing, whose children are its elements, the row above it where it has one, and what is open over it,
/// as the editor of a name.
class DrawingAccessible final : public QAccessibleWidget {
 public:
  explicit DrawingAccessible(DrawingView* view) : QAccessibleWidget(view, QAccessible::Canvas), m_view(view) {
    QObject::connect(view, &DrawingView::walkedTo, view, [this](const ElementId& element) {
      if (!QAccessible::isActive()) return;
      QAccessibleEvent event(elementOf(element), QAccessible::Focus);
      QAccessible::updateAccessibility(&event);
    });
  }
  ~DrawingAccessible() override {
    for (const auto& [element, id] : m_ids) QAccessible::deleteAccessibleInterface(id);
  }
  DrawingAccessible(const DrawingAccessible&) = delete;
  DrawingAccessible& operator=(const DrawingAccessible&) = delete;

  [[nodiscard]] int childCount() const override {
    return static_cast<int>(elements().size()) + static_cast<int>(editors().size());
  }
  [[nodiscard]] QAccessibleInterface* child(int index) const override {
    const std::vector<ElementId>& drawn = elements();
    const auto at = static_cast<std::size_t>(index);
    if (index >= 0 && at < drawn.size()) return elementOf(drawn[at]);
    const QWidgetList open = editors();
    const qsizetype editor = index - static_cast<qsizetype>(drawn.size());
    return editor >= 0 && editor < open.size() ? QAccessible::queryAccessibleInterface(open[editor])
                                               : nullptr;
  }
  [[nodiscard]] int indexOfChild(const QAccessibleInterface* child) const override {
    const int count = childCount();
    for (int i = 0; i < count; ++i) {
      if (this->child(i) == child) return i;
    }
    return -1;
  }
  [[nodiscard]] QAccessibleInterface* childAt(int x, int y) const override {
    for (int i = 0; i < childCount(); ++i) {
      if (QAccessibleInterface* each = child(i); each->rect().contains(x, y)) return each;
    }
    return nullptr;
  }
  [[nodiscard]] QAccessibleInterface* focusChild() const override {
    if (!m_view->hasFocus()) return QAccessibleWidget::focusChild();
    const auto current = m_view->currentElement();
    return current ? elementOf(*current) : const_cast<DrawingAccessible*>(this);
  }

 private:
  /// What is drawn, listed again when that is another: a reader asks for one child after the other.
  [[nodiscard]] const std::vector<ElementId>& elements() const {
    const auto* scene = static_cast<const DrawingScene*>(m_view->scene());
    const std::tuple now(scene->drawnParts(), scene->outlines().data(), scene->outlines().size());
    if (std::exchange(m_listed, now) != now) m_elements = m_view->drawnElements();
    return m_elements;
  }
  [[nodiscard]] QWidgetList editors() const {
    QWidgetList open =
        m_view->findChildren<QWidget*>(QStringLiteral("drawingBar"), Qt::FindDirectChildrenOnly);
    open += m_view->viewport()->findChildren<QWidget*>(Qt::FindDirectChildrenOnly);
    open.removeIf([](const QWidget* each) { return each->isHidden(); });
    return open;
  }
  [[nodiscard]] QAccessibleInterface* elementOf(const ElementId& element) const {
    auto found = m_ids.find(element);
    if (found == m_ids.end()) {
      const auto id = QAccessible::registerAccessibleInterface(new ElementAccessible(m_view, element));
      found = m_ids.emplace(element, id).first;
    }
    return QAccessible::accessibleInterface(found->second);
  }

  DrawingView* m_view;
  mutable std::tuple<quint64, const Outline*, std::size_t> m_listed{};
  mutable std::vector<ElementId> m_elements;
  mutable std::map<ElementId, QAccessible::Id> m_ids;
};

QAccessibleInterface* accessibleOf(const QString&, QObject* object) {
  auto* view = qobject_cast<DrawingView*>(object);
  return view != nullptr ? new DrawingAccessible(view) : nullptr;
}

}  // namespace

void installDrawingAccessibility() {
  static const bool once = [] {
    QAccessible::installFactory(&accessibleOf);
    return true;
  }();
  Q_UNUSED(once)
}

}  // namespace geargraph
