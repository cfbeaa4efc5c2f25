#include "ui/canvas/weld_edits.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/mechanism/model/link_edits.h"
#include "core/theory/states/weld_edits.h"
#include "ui/canvas/canvas_edits.h"
#include "ui/models/term_tips.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("canvas", text);
}

std::vector<LinkId> linksOf(const std::set<ElementId>& selected) {
  std::vector<LinkId> links;
  for (const ElementId& element : selected) {
    if (element.kind == ElementKind::link) links.emplace_back(element.id);
  }
  return links;
}

QString whyRejected(const Expected<Mechanism>& made) {
  return made ? QString() : shownText(made.error().front().message);
}

}  // namespace

std::optional<std::pair<LinkId, LinkId>> linksToWeld(const Mechanism& now,
                                                     const std::set<ElementId>& selected) {
  const std::vector<LinkId> links = linksOf(selected);
  if (links.size() != 2 || selected.size() != 2) return std::nullopt;
  for (const Link& link : now.links) {
    if (link.id == links[0]) return std::pair(links[0], links[1]);
    if (link.id == links[1]) return std::pair(links[1], links[0]);
  }
  return std::nullopt;
}

Edit weldEdit(const Mechanism& now, LinkId kept, LinkId other) {
  return {tr("Weld %1 and %2").arg(describe(now, {kept}), describe(now, {other})),
          [kept, other](const Mechanism& mechanism) { return withLinksWelded(mechanism, kept, other); }, 0};
}

QString whyNoWeld(const Mechanism& now, const std::set<ElementId>& selected) {
  const auto links = linksToWeld(now, selected);
  if (!links) return tr("Select the two links that should be one: click one, then the other with Shift.");
  return whyRejected(withLinksMerged(now, links->first, links->second));
}

std::optional<Split> splitOf(const Mechanism& now, const std::set<ElementId>& selected) {
  const std::vector<LinkId> links = linksOf(selected);
  if (links.size() != 1) return std::nullopt;
  Split split{links.front(), {}};
  for (const ElementId& element : selected) {
    if (element.kind == ElementKind::link) continue;
    const bool canMove = element.kind == ElementKind::turningJoint || element.kind == ElementKind::gearMesh ||
                         element.kind == ElementKind::coupling;
    if (!canMove) return std::nullopt;
    split.moving.push_back(element);
  }
  if (split.moving.empty()) split.moving = lastSideOf(now, split.link);
  return split;
}

Edit splitEdit(const Mechanism& now, const Split& split, std::optional<CanvasPoint> at) {
  return {tr("Split %1").arg(describe(now, {split.link})),
          [split, at](const Mechanism& mechanism) {
            return withLinkDivided(mechanism, split.link, split.moving, at);
          },
          0};
}

QString whyNoSplit(const Mechanism& now, const std::set<ElementId>& selected) {
  const std::optional<Split> split = splitOf(now, selected);
  if (!split)
    return tr("Select one link, and with Shift the joints and meshes that its new half should take.");
  return whyRejected(withLinkSplit(now, split->link, split->moving));
}

}  // namespace geargraph
