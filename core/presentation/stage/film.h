#pragma once

#include <cstdint>
#include <stop_token>
#include <string>

#include "core/presentation/painting/image.h"
#include "core/presentation/stage/stage_view.h"

namespace geargraph::inline stage {

/// What runs in a film: the viewer once round the train, or the train through its period.
enum class FilmKind : std::uint8_t { turntable, motion };

constexpr int kMostFilmFrames = 10'000;

/// A film of a view. It is closed: the picture after the last is the first one again, where the motion has a
/// period.
struct Film {
  FilmKind kind = FilmKind::turntable;
  int frames = 72;
  double framesPerSecond = 24;
  double seconds = 0;  ///< of motion that the whole film shows; 0: one period, there and back between the
                       ///< limits of joints, or a minute where there is none
};

/// How much of the motion the film shows, s.
[[nodiscard]] double filmSpan(const Stage& stage, const Film& film);

/// The view of one picture of the film; a view with a trajectory runs along it, again from its beginning
/// after its end. Identity: picture 0 is the view itself. @pre 0 <= picture < frames
[[nodiscard]] StageView filmView(const Stage& stage, const StageView& view, const Film& film, int picture);

/// Writes an animated PNG (the APNG extension of PNG, third edition) piece by piece: what programs show that
/// know no animation is its first picture. After the first, only the rectangle that changed is stored.
class AnimatedPng {
 public:
  /// @pre as many pictures will be added, all of one size; they repeat for ever
  AnimatedPng(int pictures, double framesPerSecond);
  /// The bytes to be written next; empty where libpng fails (out of memory) or `stop` was requested.
  [[nodiscard]] std::string add(const Image& image, const std::stop_token& stop = {});
  /// The last bytes. @pre all pictures were added
  [[nodiscard]] std::string end() const;

 private:
  struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;
  };
  [[nodiscard]] Rectangle changed(const Image& image) const;
  [[nodiscard]] std::string control(const Rectangle& where);

  int m_pictures;
  std::uint16_t m_delay;  ///< thousandths of a second a picture
  std::uint32_t m_sequence = 0;
  int m_added = 0;
  Image m_last;
};

}  // namespace geargraph::inline stage
