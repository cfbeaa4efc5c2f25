#include "ui/teeth_panel/wheel_names.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/foundations/base/text_lists.h"
#include "core/mechanism/model/pins.h"
#include "ui/models/link_text.h"
#include "ui/models/term_tips.h"

namespace geargraph {
namespace {

constexpr qsizetype kMaxNameLetters = 10;

QString tr(const char* text) {
  return QCoreApplication::translate("teeth", text);
}

const GearMesh& meshOfEnd(const Mechanism& train, int end) {
  return train.gearMeshes[static_cast<std::size_t>(end / 2)];
}

LinkId linkOfEnd(const Mechanism& train, int end) {
  const GearMesh& mesh = meshOfEnd(train, end);
  return end % 2 == 0 ? mesh.tail : mesh.head;
}

LinkId otherLinkOfEnd(const Mechanism& train, int end) {
  return linkOfEnd(train, end % 2 == 0 ? end + 1 : end - 1);
}

int positionOf(const Mechanism& train, LinkId link) {
  const auto found =
      std::find_if(train.links.begin(), train.links.end(), [&](const Link& each) { return each.id == link; });
  return static_cast<int>(found - train.links.begin());
}

/// The labels of the links that the first of equal wheels meshes with.
std::string partnersOf(const Mechanism& train, const SearchedWheel& wheel) {
  std::vector<std::string> labels;
  for (const int end : wheel.ends) {
    if (linkOfEnd(train, end) != linkOfEnd(train, wheel.ends.front())) continue;
    labels.push_back(std::to_string(train.linkLabel(positionOf(train, otherLinkOfEnd(train, end)))));
  }
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  return listed(labels, 6);
}

}  // namespace

std::vector<WheelName> wheelNames(const TeethProblem& problem) {
  const Mechanism& train = problem.drawn.mechanism();
  std::vector<WheelName> names;
  for (const SearchedWheel& wheel : problem.wheels) {
    const int end = wheel.ends.front();
    const LinkId link = linkOfEnd(train, end);
    const int position = positionOf(train, link);
    const Link& of = train.links[static_cast<std::size_t>(position)];
    const QString label = QString::number(train.linkLabel(position));
    const auto onLink = std::count_if(problem.wheels.begin(), problem.wheels.end(), [&](const auto& each) {
      return linkOfEnd(train, each.ends.front()) == link;
    });
    const GearMesh& mesh = meshOfEnd(train, end);
    const auto& id = end % 2 == 0 ? mesh.tailWheel : mesh.headWheel;
    QString mark = label;
    if (onLink > 1)
      mark = id ? shownText(id->text()) : label + QStringLiteral("·%1").arg(train.meshLabel(end / 2));
    QString name = shownText(of.name).simplified();
    if (name.size() > kMaxNameLetters) name = name.left(kMaxNameLetters - 1).trimmed() + QStringLiteral("…");
    names.push_back(
        {mark, name.isEmpty() ? mark : mark + QLatin1Char(' ') + name,
         tr("%1, meshes with %2").arg(linkText(label, of.name), shownText(partnersOf(train, wheel))), link,
         train.colorNumber(position), isPinned(of)});
  }
  return names;
}

}  // namespace geargraph
