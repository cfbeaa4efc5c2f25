#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace geargraph::inline languages {

/// The languages of the program: "en" and those of resources/translations/geargraph_*.ts, by their two
/// letters.
[[nodiscard]] const std::vector<QString>& languageCodes();

/// What a language calls itself: "Deutsch".
[[nodiscard]] QString nativeName(const QString& code);

/// The language that was chosen last, of the settings; empty where none was, so that it is the system's.
[[nodiscard]] QString savedLanguage();
/// Empty: the system's from now on.
void saveLanguage(const QString& code);
/// The first of the system's languages that the program has; English where it has none.
[[nodiscard]] QString systemLanguage();

/// From now on all texts, core's and Qt's own dialogs' too, are looked up in this language, and numbers,
/// dates and paper are as its countries write them: of the system's country where that speaks it. What was
/// shown before stays as it is: windows are built anew. @pre one of languageCodes(); called on the thread of
/// the GUI
void useLanguage(const QString& code);
/// The one in use; English at first.
[[nodiscard]] QString currentLanguage();

}  // namespace geargraph::inline languages
