#pragma once

class QWidget;

namespace geargraph {

/// Is any of the widget within its window and all that it stands in? A panel behind others in tabs is not.
/// Unlike visibleRegion(), which leaves out what opaque children cover, up to all of a panel.
[[nodiscard]] bool isInSight(const QWidget& widget);

}  // namespace geargraph
