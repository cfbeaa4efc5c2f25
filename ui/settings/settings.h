#pragma once

#include <QSettings>
#include <QString>
#include <QVariant>
#include <functional>

namespace geargraph {

// The settings of the program, which QSettings keeps in a file. A QSettings writes on the thread that changes
// it, and waits until the disk has the file: 20 to 130 ms. Here a thread of its own does so. Nothing waits
// for it but flushSettings(); what has been saved is read as saved from then on. To be called on the
// thread of the windows only.

/// The saved value, or `otherwise` if there is none.
[[nodiscard]] QVariant savedSetting(const QString& key, const QVariant& otherwise = {});
[[nodiscard]] bool isSettingSaved(const QString& key);

void saveSetting(const QString& key, const QVariant& value);
void removeSetting(const QString& key);
/// Makes other changes on the writing thread, such as of an array, to keys that begin with `group`.
/// savedSetting() does not know them until they are written: flushSettings() first.
void changeSettings(const QString& group, std::function<void(QSettings& settings)> change);

/// Blocks until everything saved before is in the file. Called at the end of the program.
void flushSettings();

}  // namespace geargraph
