#include "ui/settings/settings.h"

#include <QCoreApplication>
#include <QHash>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace geargraph {
namespace {

class SettingsWriter {
 public:
  using Change = std::function<void(QSettings& settings)>;

  static SettingsWriter& instance() {
    static SettingsWriter writer;
    return writer;
  }

  /// The value of a key; invalid if there is none.
  [[nodiscard]] QVariant value(const QString& key) {
    {
      // A QSettings would wait for the one that writes.
      const std::lock_guard lock(m_mutex);
      const auto known = m_known.constFind(key);
      if (m_isBusy && known != m_known.constEnd()) return *known;
    }
    const QVariant read = QSettings().value(key);
    const std::lock_guard lock(m_mutex);
    if (!m_isBusy) m_known[key] = read;
    return read;
  }

  void add(const QString& key, const QVariant& value, Change change) {
    const std::lock_guard lock(m_mutex);
    m_known[key] = value;
    addLocked(std::move(change));
  }
  void addToGroup(const QString& group, Change change) {
    const std::lock_guard lock(m_mutex);
    m_known.removeIf([&](const auto& known) { return known.key().startsWith(group); });
    addLocked(std::move(change));
  }

  void flush() {
    std::unique_lock lock(m_mutex);
    m_written.wait(lock, [this] { return !m_isBusy; });
  }

 private:
  SettingsWriter() {
    qAddPostRoutine(flushSettings);  // before the application forgets whose settings they are
    m_thread = std::jthread([this](const std::stop_token& quit) { run(quit); });
  }

  void addLocked(Change change) {
    m_waiting.push_back(std::move(change));
    m_isBusy = true;
    m_wake.notify_one();
  }

  void run(const std::stop_token& quit) {
    std::unique_lock lock(m_mutex);
    while (m_wake.wait(lock, quit, [this] { return !m_waiting.empty(); })) {
      const std::deque<Change> changes = std::exchange(m_waiting, {});
      lock.unlock();
      {
        QSettings settings;
        for (const Change& change : changes) change(settings);
      }  // writes the file
      lock.lock();
      m_isBusy = !m_waiting.empty();
      if (!m_isBusy) m_written.notify_all();
    }
  }

  std::mutex m_mutex;
  std::condition_variable_any m_wake;
  std::condition_variable m_written;
  std::deque<Change> m_waiting;
  QHash<QString, QVariant> m_known;  ///< as last read or saved; invalid: none
  bool m_isBusy = false;             ///< something waits or is being written
  std::jthread m_thread;             ///< last: stopped before the members it uses are destroyed
};

}  // namespace

QVariant savedSetting(const QString& key, const QVariant& otherwise) {
  const QVariant value = SettingsWriter::instance().value(key);
  return value.isValid() ? value : otherwise;
}

bool isSettingSaved(const QString& key) {
  return SettingsWriter::instance().value(key).isValid();
}

void saveSetting(const QString& key, const QVariant& value) {
  SettingsWriter::instance().add(key, value, [=](QSettings& settings) { settings.setValue(key, value); });
}

void removeSetting(const QString& key) {
  SettingsWriter::instance().add(key, {}, [=](QSettings& settings) { settings.remove(key); });
}

void changeSettings(const QString& group, std::function<void(QSettings& settings)> change) {
  SettingsWriter::instance().addToGroup(group, std::move(change));
}

void flushSettings() {
  SettingsWriter::instance().flush();
}

}  // namespace geargraph
