#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace geargraph {

/// The languages of the program: "en" and those of resources/translations/geargraph_*.ts, by their two
/// letters.
[[nodiscard]] const std::vector<QString>& languageCodes();

/// The native name of a language: "Deutsch".
[[nodiscard]] QString nativeName(const QString& code);

/// The last chosen language, from the settings; empty: none, use the system's.
[[nodiscard]] QString savedLanguage();
/// Saves the chosen language; empty: the system's.
void saveLanguage(const QString& code);
/// The first of the system's languages that the program has, else English.
[[nodiscard]] QString systemLanguage();

/// Switches all texts, including those of core and of Qt's dialogs, to this language, and numbers, dates and
/// paper sizes to its locale: that of the system's country if the language is spoken there. Existing widgets
/// do not change: windows have to be rebuilt. @pre one of languageCodes(); on the GUI thread
void useLanguage(const QString& code);
/// The current language; initially English.
[[nodiscard]] QString currentLanguage();

}  // namespace geargraph
