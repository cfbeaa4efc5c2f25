// `soak_disk [--seed N] [--runs N | --minutes M]`: exports and saves on a disk that fails (failing_disk.cpp).
// Each run lets one call fail: what is reported as written is whole, else the error is reported and what was
// there before remains. Without options each fault meets the first and a later call of each program once.
// Findings are printed; exit status 1.

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>

#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "tests/core/support/example_files.h"
#include "tests/faults/child.h"
#include "tests/faults/soak_options.h"
#include "tests/faults/versions.h"

using namespace geargraph;

namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;  ///< contents by the path from the folder

struct Fault {
  const char* call;
  const char* error;
  bool isHarmless = false;  ///< the program goes on by itself
};

constexpr std::array kFaults = {
    Fault{"open", "ENOSPC"},       Fault{"open", "EACCES"},  Fault{"write", "ENOSPC"},
    Fault{"write", "EIO"},         Fault{"write", "EDQUOT"}, Fault{"write", "short", true},
    Fault{"write", "EINTR", true}, Fault{"fsync", "EIO"},    Fault{"fsync", "ENOSPC"},
    Fault{"close", "EIO"},         Fault{"rename", "EIO"},   Fault{"rename", "ENOSPC"},
    Fault{"fchmod", "EIO"}};

const std::string kOld = "what was there before";

/// A program that writes into a folder.
struct Task {
  const char* name;
  std::vector<std::string> words;   ///< "@": the folder
  std::vector<std::string> before;  ///< files that are there, with kOld
  bool writesSeveral = false;       ///< files
};

std::vector<Task> exportTasks() {
  const std::string robot = test::examplePath("robot"), pair = test::examplePath("spur-pair");
  const auto exported = [](const char* name, const std::string& document, std::vector<std::string> options,
                           const std::string& out) {
    std::vector<std::string> words = {GEARGRAPH_CLI, "export", document, "--to"};
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), {"-o", "@/" + out});
    return Task{name, words, {out}};
  };
  std::vector<Task> tasks = {
      exported("csv", robot, {"csv", "--matrix", "p"}, "p.csv"),
      exported("html", robot, {"html"}, "robot.html"),
      exported("png", robot, {"png", "--view", "digraph"}, "robot.png"),  // a PDF holds the time
      exported("glb", pair, {"glb"}, "pair.glb"),
      exported("obj", pair, {"obj"}, "pair.obj"),
      exported("assembly", pair, {"assembly"}, "teeth"),
  };
  tasks[4].before.emplace_back("pair.mtl");
  tasks[5].before.clear();
  tasks[4].writesSeveral = tasks[5].writesSeveral = true;
  tasks.push_back(exported("new file", pair, {"stl"}, "pair.stl"));
  tasks.back().before.clear();
  return tasks;
}

Files filesIn(const fs::path& folder) {
  Files files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string name = fs::relative(entry.path(), folder).string();
    files[name] = entry.is_directory() ? "" : std::string{std::istreambuf_iterator<char>(file), {}};
  }
  return files;
}

class Disk {
 public:
  /// One fault in one call of one export. True where the program got to that call.
  bool exportWith(const Task& task, const Fault& fault, long number, bool goesOn) {
    const auto [ended, after, happened] = run(task, environmentOf(fault, number, goesOn));
    const std::string what =
        std::string(task.name) + ", " + fault.call + " " + std::to_string(number) + " " + fault.error;
    const Files whole = reference(task);
    if (ended.status == 0) {
      if (after != whole) finding(what + ": reported as written, but the files differ");
      if (happened && !fault.isHarmless) finding(what + ": nothing was reported");
    } else {
      if (fault.isHarmless) finding(what + ": failed for no reason: " + ended.errors);
      if (ended.status != 2 || ended.errors.find("could not be") == std::string::npos)
        finding(what + ": status " + std::to_string(ended.status) + ", \"" + ended.errors + "\"");
      for (const auto& [name, contents] : after) {
        const auto made = whole.find(name);
        const bool isOld = contents == kOld && contains(task.before, name);
        if (!isOld && (made == whole.end() || made->second != contents))
          finding(what + ": " + name + " is neither old nor new");
      }
      for (const std::string& name : task.before) {
        if (!after.contains(name)) finding(what + ": " + name + " is lost");
      }
      if (task.before.empty() && !after.empty()) finding(what + ": leaves " + after.begin()->first);
    }
    return happened;
  }

  /// One fault while the editor's document is edited, kept and saved so many times.
  bool saveWith(const Fault& fault, long number, bool goesOn, int edits) {
    const Task task{"save", {GEARGRAPH_EDITOR_DRIVER, "@", std::to_string(edits)}, {}};
    const auto [ended, after, happened] = run(task, environmentOf(fault, number, goesOn),
                                              {{"document.geargraph", writeMechanism(test::version(0))}});
    const std::string what =
        std::string("save, ") + fault.call + " " + std::to_string(number) + " " + fault.error;
    if (ended.status != 0) finding(what + ": status " + std::to_string(ended.status) + " " + ended.errors);
    int saved = 0;
    for (int i = 1; i <= edits; ++i) {
      if (ended.output.find("\nsaved " + std::to_string(i) + "\n") != std::string::npos) saved = i;
    }
    const auto document = after.find("document.geargraph");
    const auto read =
        document == after.end() ? Expected<Mechanism>(Diagnostics{}) : readMechanism(document->second);
    if (!read || test::versionOf(*read) != saved) finding(what + ": the document is not what was saved last");
    const bool reported = ended.output.find("not saved: ") != std::string::npos ||
                          ended.output.find("not kept: ") != std::string::npos;
    if (happened && !fault.isHarmless && !reported) finding(what + ": nothing was reported: " + ended.output);
    if (reported && (!happened || fault.isHarmless))
      finding(what + ": failed for no reason: " + ended.output);
    for (const auto& [name, contents] : after) {
      if (name.ends_with(".tmp")) finding(what + ": leaves " + name);
    }
    return happened;
  }

  void summary() const {
    std::printf("soak_disk: %ld runs, %ld faults, %ld findings\n", m_runs, m_faults, m_findings);
  }
  [[nodiscard]] long runs() const { return m_runs; }
  [[nodiscard]] long findings() const { return m_findings; }

 private:
  using Environment = std::map<std::string, std::string>;

  struct Run {
    test::Ended ended;
    Files after;
    bool happened = false;
  };

  static bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }
  static Environment environmentOf(const Fault& fault, long number, bool goesOn) {
    return {{"LD_PRELOAD", GEARGRAPH_FAILING_DISK},
            {"ASAN_OPTIONS", "verify_asan_link_order=0:detect_leaks=0"},
            {"GEARGRAPH_DISK_FAULT",
             std::string(fault.call) + ":" + std::to_string(number) + (goesOn ? "+:" : ":") + fault.error}};
  }

  void finding(const std::string& what) {
    ++m_findings;
    std::fprintf(stderr, "%s\n", what.c_str());
  }

  Run run(const Task& task, Environment environment, const Files& more = {}) {
    const test::TemporaryFolder folder, marks;
    for (const std::string& name : task.before) std::ofstream(folder.path() + "/" + name) << kOld;
    for (const auto& [name, contents] : more) std::ofstream(folder.path() + "/" + name) << contents;
    std::vector<std::string> words = task.words;
    for (std::string& word : words) {
      if (word.starts_with('@')) word.replace(0, 1, folder.path());
    }
    environment["GEARGRAPH_DISK_FOLDER"] = folder.path();
    environment["GEARGRAPH_DISK_MARK"] = marks.path() + "/happened";
    Run result;
    result.ended = test::Child(words, environment).ended();
    result.after = filesIn(folder.path());
    result.happened = fs::exists(marks.path() + "/happened");
    ++m_runs;
    m_faults += result.happened ? 1 : 0;
    return result;
  }

  /// What the task writes on a sound disk.
  const Files& reference(const Task& task) {
    auto found = m_references.find(task.name);
    if (found == m_references.end()) {
      Run sound = run(task, {});
      if (sound.ended.status != 0)
        finding(std::string(task.name) + " fails on a sound disk: " + sound.ended.errors);
      found = m_references.emplace(task.name, std::move(sound.after)).first;
    }
    return found->second;
  }

  std::map<std::string, Files> m_references;
  long m_runs = 0, m_faults = 0, m_findings = 0;
};

/// Each fault in the first call, and where several files are written in all from the third on; in turns when
/// unsaved changes are kept and when they are saved.
void eachOnce(Disk& disk) {
  long number = 0;
  for (const Fault& fault : kFaults) {
    number = 3 - std::max(number, 1L);  // 2, 1, 2, ...
    bool happened = false;
    for (const Task& task : exportTasks()) {
      happened = disk.exportWith(task, fault, 1, false) || happened;
      if (!fault.isHarmless && task.writesSeveral) disk.exportWith(task, fault, 3, true);
    }
    if (!happened) std::exit(3);  // the library is not in the way of this call
    if (!disk.saveWith(fault, number, false, 1)) disk.saveWith(fault, 1, false, 1);
  }
}

void atRandom(Disk& disk, const test::SoakOptions& options) {
  std::mt19937_64 random(options.seed);
  const std::vector<Task> tasks = exportTasks();
  while (options.goesOn(disk.runs())) {
    const Fault& fault = kFaults[random() % kFaults.size()];
    const long number = 1 + static_cast<long>(random() % 12);
    const bool goesOn = !fault.isHarmless && random() % 2 == 0;
    const std::size_t which = random() % (tasks.size() + 1);
    if (which < tasks.size()) {
      disk.exportWith(tasks[which], fault, number, goesOn);
    } else {
      disk.saveWith(fault, number, goesOn, 2);
    }
  }
}

}  // namespace

int main(int count, char** words) {
  Disk disk;
  if (count > 1) {
    atRandom(disk, test::SoakOptions(count, words, 100));
  } else {
    eachOnce(disk);
  }
  disk.summary();
  return disk.findings() == 0 ? 0 : 1;
}
