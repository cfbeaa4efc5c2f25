#include "ui/settings/languages.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <array>
#include <memory>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/locale.h"
#include "core/foundations/base/translation.h"
#include "ui/settings/settings.h"

namespace geargraph {
namespace {

const QString kSetting = QStringLiteral("language");
constexpr const char* kContext = "GearGraph";  // of all texts: see tools/translations/extract.cmake

QString catalogueOf(const char* whose, const QString& code) {
  return QStringLiteral(":/translations/%1_%2.qm").arg(QLatin1String(whose), code);
}

/// The program's catalogue, which knows no contexts: a text says the same wherever it is shown.
class CatalogueTranslator : public QTranslator {
 public:
  using QTranslator::QTranslator;

  QString translate(const char* /*context*/, const char* source, const char* disambiguation,
                    int n) const override {
    return QTranslator::translate(kContext, source, disambiguation, n);
  }
};

struct Installed {
  QString code = QStringLiteral("en");
  std::unique_ptr<QTranslator> ofQt;
  std::shared_ptr<const CatalogueTranslator> own;  ///< shared with threads that are composing a text of core
};

Installed& installed() {
  static Installed now;
  return now;
}

QLocale localeOf(const QString& code) {
  const QLocale system = QLocale::system();
  return system.name().startsWith(code) ? system : QLocale(code);
}

}  // namespace

const std::vector<QString>& languageCodes() {
  static const std::vector<QString> codes = {QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("tr"),
                                             QStringLiteral("es")};
  return codes;
}

QString nativeName(const QString& code) {
  if (code == QLatin1String("en")) return QStringLiteral("English");  // not "American English"
  if (code == QLatin1String("es")) return QStringLiteral("Español");
  return QLocale(code).nativeLanguageName();
}

QString savedLanguage() {
  const QString code = savedSetting(kSetting).toString();
  const auto& all = languageCodes();
  return std::find(all.begin(), all.end(), code) != all.end() ? code : QString();
}

void saveLanguage(const QString& code) {
  if (code.isEmpty()) {
    removeSetting(kSetting);
  } else {
    saveSetting(kSetting, code);
  }
}

QString systemLanguage() {
  for (const QString& wanted : QLocale::system().uiLanguages()) {
    for (const QString& code : languageCodes()) {
      if (wanted.left(2) == code) return code;
    }
  }
  return QStringLiteral("en");
}

void useLanguage(const QString& code) {
  Installed& now = installed();
  now.ofQt.reset();  // a translator that is deleted is removed
  setCatalogue(nullptr);
  if (now.own) QCoreApplication::removeTranslator(const_cast<CatalogueTranslator*>(now.own.get()));
  now.own.reset();
  now.code = code;
  const QLocale locale = localeOf(code);
  QLocale::setDefault(locale);
  setDecimalSign(locale.decimalPoint() == QLatin1String(",") ? ',' : '.');
  if (code == QLatin1String("en")) return;

  now.ofQt = std::make_unique<QTranslator>();
  auto own = std::make_shared<CatalogueTranslator>();
  const bool isThere =
      now.ofQt->load(catalogueOf("qtbase", code)) && own->load(catalogueOf("geargraph", code));
  GEARGRAPH_REQUIRE(isThere);  // they are part of the program
  QCoreApplication::installTranslator(now.ofQt.get());
  QCoreApplication::installTranslator(own.get());
  now.own = own;
  setCatalogue([catalogue = now.own](const char* source, int n) {
    return catalogue->translate(kContext, source, nullptr, n).toStdString();
  });
}

QString currentLanguage() {
  return installed().code;
}

}  // namespace geargraph
