#include "ui/models/link_text.h"

#include <QCoreApplication>

namespace geargraph {
namespace {

constexpr qsizetype kMaxLetters = 24;

QString tr(const char* text) {
  return QCoreApplication::translate("LinkText", text);
}

QString shortened(const std::string& name) {
  const QString text = QString::fromStdString(name).simplified();
  return text.size() <= kMaxLetters ? text : text.left(kMaxLetters - 1).trimmed() + QStringLiteral("…");
}

bool repeats(const QString& name, const QString& label) {
  return name == label || name.compare(tr("link %1").arg(label), Qt::CaseInsensitive) == 0;
}

}  // namespace

QString linkText(const QString& label, const std::string& name) {
  const QString text = shortened(name);
  if (text.isEmpty() || repeats(text, label)) return tr("link %1").arg(label);
  return tr("link %1 (%2)").arg(label, text);
}

QString relativeText(const QString& head, const std::string& headName, const QString& tail) {
  const QString link = linkText(head, headName);
  return tail == QLatin1String("0") ? link : tr("%1 relative to %2").arg(link, tail);
}

const std::string& LinkNames::nameOf(int node) const {
  const auto at = static_cast<std::size_t>(node);
  const std::vector<Link>& known = m_snapshot->mechanism->links;
  const bool isNewest =
      m_newest && m_newest->links.size() == known.size() && m_newest->links[at].id == known[at].id;
  return isNewest ? m_newest->links[at].name : known[at].name;
}

}  // namespace geargraph
