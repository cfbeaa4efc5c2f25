#include "core/presentation/scene3d/animation.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <string_view>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr double kSpanWithoutPeriod = 60;  // s
constexpr std::size_t kSignature = 8, kChunkFrame = 12;

void appendNumber(std::string& bytes, std::uint32_t value, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8)
    bytes += static_cast<char>((value >> static_cast<unsigned>(shift)) & 255U);
}

/// A chunk of PNG: length, type, content, checksum of type and content.
std::string chunk(std::string_view type, std::string_view content) {
  std::string bytes;
  appendNumber(bytes, static_cast<std::uint32_t>(content.size()), 4);
  const std::string body = std::string(type) + std::string(content);
  bytes += body;
  const auto* data = reinterpret_cast<const Bytef*>(body.data());  // NOLINT
  appendNumber(bytes, static_cast<std::uint32_t>(crc32(0, data, static_cast<uInt>(body.size()))), 4);
  return bytes;
}

struct Chunk {
  std::string_view type;
  std::string_view content;
};

/// The chunks of a PNG that we have made ourselves.
std::vector<Chunk> chunksOf(std::string_view png) {
  std::vector<Chunk> chunks;
  for (std::size_t at = kSignature; at + kChunkFrame <= png.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8U | static_cast<unsigned char>(png[at + i]);
    chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, length)});
    at += length + kChunkFrame;
  }
  return chunks;
}

Image cutOut(const Image& image, int x, int y, int width, int height) {
  Image part{width, height, {}};
  for (int row = y; row < y + height; ++row) {
    const auto first = image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(row) * image.width + x);
    part.rgba.insert(part.rgba.end(), first, first + 4 * static_cast<std::ptrdiff_t>(width));
  }
  return part;
}

SceneRange rangeOf(const MechanismScene& stage, const SceneView& view) {
  if (!stage.range) return {};
  std::vector<double> added = view.turned;
  added.resize(stage.inputSpeeds.size(), 0);
  return stage.range(added);
}

/// The time at which a motion is that turns round at the ends of its range.
double turnedRound(const SceneRange& range, double time) {
  const double from = range.from.time;
  const double to = range.to.time;
  if (std::isfinite(from) && std::isfinite(to)) {
    const double there = to - from;
    if (there <= 0) return from;
    const double place = std::fmod(std::fmod(time - from, 2 * there) + 2 * there, 2 * there);
    return from + (place <= there ? place : 2 * there - place);
  }
  if (time > to) return 2 * to - time;
  return time < from ? 2 * from - time : time;
}

}  // namespace

double animationSpan(const MechanismScene& stage, const Animation& animation) {
  if (animation.seconds > 0) return animation.seconds;
  const SceneRange range = rangeOf(stage, {});
  const double thereAndBack = 2 * (range.to.time - range.from.time);
  if (std::isfinite(thereAndBack) && thereAndBack > 0) return thereAndBack;
  return stage.period > 0 ? stage.period : kSpanWithoutPeriod;
}

SceneView animationView(const MechanismScene& stage, const SceneView& view, const Animation& animation,
                        int picture) {
  GEARGRAPH_REQUIRE(picture >= 0 && picture < animation.frames);
  const double part = static_cast<double>(picture) / animation.frames;
  SceneView now = view;
  if (animation.kind == AnimationKind::turntable) {
    const Camera& from = view.camera;
    now.camera = Camera::from(from.yaw() + 2 * std::numbers::pi * part, from.pitch())
                     .placedAt(from.target(), from.distance());
  } else {
    const InputTrajectory* const trajectory = trajectoryOf(stage, view);
    if (trajectory != nullptr && trajectory->seconds() > 0) {
      const double span = animation.seconds > 0 ? animation.seconds : trajectory->seconds();
      if (picture > 0) now.time = std::fmod(view.time + span * part, trajectory->seconds());
      return now;
    }
    now.time = turnedRound(rangeOf(stage, view), view.time + animationSpan(stage, animation) * part);
  }
  return now;
}

AnimatedPng::AnimatedPng(int pictures, double framesPerSecond)
    : m_pictures(pictures),
      m_delay(static_cast<std::uint16_t>(std::clamp(std::lround(1000 / framesPerSecond), 1L, 65535L))) {}

AnimatedPng::Rectangle AnimatedPng::changed(const Image& image) const {
  int left = image.width, right = -1, top = image.height, bottom = -1;
  const std::size_t row = 4 * static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* now = image.rgba.data() + row * static_cast<std::size_t>(y);
    const std::uint8_t* before = m_last.rgba.data() + row * static_cast<std::size_t>(y);
    if (std::memcmp(now, before, row) == 0) continue;
    top = std::min(top, y);
    bottom = y;
    std::size_t first = 0, last = row - 1;
    while (now[first] == before[first]) ++first;
    while (now[last] == before[last]) --last;
    left = std::min(left, static_cast<int>(first / 4));
    right = std::max(right, static_cast<int>(last / 4));
  }
  if (right < 0) return {0, 0, 1, 1};  // a picture may not be empty
  return {left, top, right - left + 1, bottom - top + 1};
}

// Each picture takes the place of what was in its rectangle, and stays.
std::string AnimatedPng::control(const Rectangle& where) {
  std::string content;
  appendNumber(content, m_sequence++, 4);
  for (const int value : {where.width, where.height, where.x, where.y})
    appendNumber(content, static_cast<std::uint32_t>(value), 4);
  appendNumber(content, m_delay, 2);
  appendNumber(content, 1000, 2);
  content += '\0';  // leave it
  content += '\0';  // source, not over
  return chunk("fcTL", content);
}

std::string AnimatedPng::add(const Image& image, const std::stop_token& stop) {
  GEARGRAPH_REQUIRE(m_added < m_pictures);
  const bool isFirst = m_added == 0;
  GEARGRAPH_REQUIRE(isFirst || (image.width == m_last.width && image.height == m_last.height));
  const Rectangle where = isFirst ? Rectangle{0, 0, image.width, image.height} : changed(image);
  const std::vector<std::uint8_t> bytes =
      pngBytes(isFirst ? image : cutOut(image, where.x, where.y, where.width, where.height), stop);
  if (bytes.empty()) return {};
  const std::string_view png(reinterpret_cast<const char*>(bytes.data()), bytes.size());  // NOLINT
  std::string written;
  if (isFirst) written = std::string(png.substr(0, kSignature));
  bool isControlled = false;
  for (const Chunk& each : chunksOf(png)) {
    if (each.type == "IDAT") {
      if (!isControlled) written += control(where);
      isControlled = true;
      std::string numbered;
      if (!isFirst) appendNumber(numbered, m_sequence++, 4);
      written += isFirst ? chunk("IDAT", each.content) : chunk("fdAT", numbered + std::string(each.content));
    } else if (isFirst && each.type != "IEND") {
      written += chunk(each.type, each.content);
      if (each.type != "IHDR") continue;
      std::string animation;
      appendNumber(animation, static_cast<std::uint32_t>(m_pictures), 4);
      appendNumber(animation, 0, 4);  // for ever
      written += chunk("acTL", animation);
    }
  }
  m_last = image;
  ++m_added;
  return written;
}

std::string AnimatedPng::end() const {
  GEARGRAPH_REQUIRE(m_added == m_pictures);
  return chunk("IEND", {});
}

}  // namespace geargraph
