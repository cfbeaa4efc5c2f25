#pragma once

namespace geargraph::inline ui_service {

/// What works on a thread of its own for a window. A window that closes tells all of it to end and goes once
/// all has ended; one by one, as their destructors would have it, the GUI thread would wait for each in turn.
class BackgroundWork {
 public:
  BackgroundWork() = default;
  virtual ~BackgroundWork() = default;
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  /// The work under way is asked to stop, and none is begun any more. Does not wait.
  virtual void tellToEnd() = 0;
  /// Has it been told to end, and is it no longer at work?
  [[nodiscard]] virtual bool hasEnded() const = 0;
};

}  // namespace geargraph::inline ui_service
