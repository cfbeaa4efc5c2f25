#pragma once

namespace geargraph {

/// An object of a window that works on a background thread. A closing window requests the end of all of them
/// and is destroyed once all have ended; in their destructors alone, the GUI thread would wait for one after
/// the other.
class BackgroundWork {
 public:
  BackgroundWork() = default;
  virtual ~BackgroundWork() = default;
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  /// Requests the current work to stop, and starts none any more. Does not wait.
  virtual void requestStop() = 0;
  /// Was the end requested, and is no work in progress?
  [[nodiscard]] virtual bool hasStopped() const = 0;
};

}  // namespace geargraph
