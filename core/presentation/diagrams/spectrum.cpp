#include "core/presentation/diagrams/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/foundations/base/translation.h"
#include "core/presentation/drawing/text_metrics.h"

namespace geargraph {
namespace {

// px
constexpr double kDecade = 150;
constexpr double kLongestAxis = 1200;  ///< with more decades each has less room
constexpr double kSpectrumTextSize = 11;
constexpr double kTick = 5;
constexpr double kRow = 14;              ///< between two rows of labels
constexpr double kSpectrumLabelGap = 6;  ///< between two labels of a row
constexpr double kLegendLine = 22;
constexpr double kLegendGap = 22;

/// How a kind is drawn: told apart by height, width and dashes, also in print.
struct LineStyle {
  FrequencyKind kind;
  const char* name;
  double height;
  double width;
  Dash dash;
  ColorRole role;
};

// In painting order, the highest last.
constexpr std::array<LineStyle, 7> kStyles = {{
    {FrequencyKind::sideband, toTranslate("sideband"), 46, 1, Dash::solid, ColorRole::secondary},
    {FrequencyKind::huntingTooth, toTranslate("hunting tooth"), 60, 1.4, Dash::dotted, ColorRole::ink},
    {FrequencyKind::assemblyPhase, toTranslate("assembly phase"), 74, 1.4, Dash::dashDotted, ColorRole::ink},
    {FrequencyKind::joint, toTranslate("turns on its bearer"), 88, 1.4, Dash::dashed, ColorRole::secondary},
    {FrequencyKind::planetPass, toTranslate("planets pass"), 102, 1.6, Dash::dashed, ColorRole::accent},
    {FrequencyKind::shaft, toTranslate("shaft"), 116, 2, Dash::solid, ColorRole::accent},
    {FrequencyKind::toothMesh, toTranslate("tooth mesh"), 130, 2.4, Dash::solid, ColorRole::ink},
}};

ElementId elementOf(const Mechanism& mechanism, const FrequencyLine& line) {
  if (line.mesh) return mechanism.gearMeshes[*line.mesh].id;
  if (line.link) return mechanism.links[*line.link].id;
  return mechanism.turningJoints[*line.joint].id;
}

/// The label of a line that bears one: "15", "2 x 15", "4".
std::string labelOfLine(const Mechanism& mechanism, const FrequencyLine& line) {
  switch (line.kind) {
    case FrequencyKind::toothMesh: {
      const std::string mesh = std::to_string(mechanism.meshLabel(*line.mesh));
      return line.harmonic == 1 ? mesh : std::to_string(line.harmonic) + "\u00d7" + mesh;
    }
    case FrequencyKind::shaft:
    case FrequencyKind::planetPass:
      return std::to_string(mechanism.linkLabel(*line.link));
    case FrequencyKind::joint:
      return std::to_string(mechanism.jointLabel(*line.joint));
    default:
      return {};
  }
}

class SpectrumMaker {
 public:
  SpectrumMaker(const Mechanism& mechanism, const std::vector<FrequencyLine>& lines)
      : m_mechanism(mechanism), m_lines(lines) {
    double least = std::log10(lines.front().ratio.toDouble());
    double most = least;
    for (const FrequencyLine& line : lines) {
      const double at = std::log10(line.ratio.toDouble());
      least = std::min(least, at);
      most = std::max(most, at);
    }
    m_first = static_cast<int>(std::floor(least));
    m_last = std::max(static_cast<int>(std::ceil(most)), m_first + 1);
    m_decade = std::min(kDecade, kLongestAxis / (m_last - m_first));
  }

  DisplayList make(const std::string& xTitle) {
    addAxis(xTitle);
    for (const LineStyle& style : kStyles) addLines(style);
    addLegend();
    m_list.sortByDepth();
    return std::move(m_list);
  }

 private:
  [[nodiscard]] double placeOf(double logarithm) const { return (logarithm - m_first) * m_decade; }

  void add(ElementId element, MarkRole role, int z, std::variant<Stroke, Fill, Text> what) {
    m_list.marks.push_back({std::move(element), role, z, std::move(what)});
  }
  void addLine(ElementId element, CanvasPoint from, CanvasPoint to, const LineStyle& style, int z) {
    add(std::move(element), MarkRole::line, z,
        Stroke{Polyline{{from, to}, false}, style.role, style.width, style.dash});
  }
  void addText(const std::string& text, CanvasPoint center, ColorRole role = ColorRole::secondary) {
    add({}, MarkRole::label, 2, Text{text, center, kSpectrumTextSize, false, role});
  }

  void addAxis(const std::string& title) {
    const LineStyle thin{FrequencyKind::shaft, "", 0, 1, Dash::solid, ColorRole::secondary};
    const double end = placeOf(m_last);
    addLine({}, {0, 0}, {end, 0}, thin, 0);
    for (int decade = m_first; decade <= m_last; ++decade) {
      const double at = placeOf(decade);
      addLine({}, {at, 0}, {at, 1.6 * kTick}, thin, 0);
      std::string number = decade >= 0 ? "1" + std::string(static_cast<std::size_t>(decade), '0')
                                       : "0." + std::string(static_cast<std::size_t>(-decade - 1), '0') + '1';
      if (std::abs(decade) > 4) number = "1e" + std::to_string(decade);
      addText(number, {at, 1.6 * kTick + kSpectrumTextSize});
      for (int part = 2; part < 10 && decade < m_last; ++part) {
        const double between = placeOf(decade + std::log10(part));
        addLine({}, {between, 0}, {between, kTick}, thin, 0);
      }
    }
    addText(title, {end / 2, 1.6 * kTick + 2.6 * kSpectrumTextSize});
  }

  void addLines(const LineStyle& style) {
    std::map<Rational, std::string> labels;  // of equal frequencies together
    for (const FrequencyLine& line : m_lines) {
      if (line.kind != style.kind) continue;
      const auto [found, isNew] = labels.try_emplace(line.ratio);
      const double at = placeOf(std::log10(line.ratio.toDouble()));
      if (isNew) addLine(elementOf(m_mechanism, line), {at, 0}, {at, -style.height}, style, 1);
      const std::string label = labelOfLine(m_mechanism, line);
      if (!label.empty()) found->second += (found->second.empty() ? "" : ", ") + label;
    }
    if (labels.empty()) return;
    m_used.push_back(&style);
    std::vector<double> ends;  // of the last label in each row above the lines
    for (const auto& [ratio, label] : labels) {
      if (label.empty()) continue;
      const double at = placeOf(std::log10(ratio.toDouble()));
      const std::string shown = elided(label, 24);
      const double half = textWidth(shown, kSpectrumTextSize, false) / 2;
      std::size_t row = 0;
      while (row < ends.size() && ends[row] + kSpectrumLabelGap > at - half) ++row;
      if (row == ends.size()) ends.push_back(at + half);
      ends[row] = at + half;
      const double y = m_labelTop - kRow * static_cast<double>(row);
      // Lines to the labels above pass behind this one.
      add({}, MarkRole::label, 1,
          Fill{Box{{{at, y}, half + 1, kSpectrumTextSize / 2 + 1}, 0}, Tint(ColorRole::sheet)});
      addText(shown, {at, y}, style.role == ColorRole::secondary ? ColorRole::secondary : ColorRole::ink);
      add({}, MarkRole::line, 0,
          Stroke{Polyline{{{at, -style.height}, {at, y + kSpectrumTextSize / 2}}, false}, ColorRole::hairline,
                 1, Dash::solid});
    }
    if (!ends.empty()) {
      addText(translated(style.name),
              {-8 - textWidth(translated(style.name), kSpectrumTextSize, false) / 2, m_labelTop},
              ColorRole::secondary);
      m_labelTop -= kRow * (static_cast<double>(ends.size()) + 0.4);
    }
  }

  void addLegend() {
    double x = 0;
    const double y = 1.6 * kTick + 4.6 * kSpectrumTextSize;
    for (const LineStyle* const style : m_used) {
      addLine({}, {x, y}, {x + kLegendLine, y}, *style, 0);
      const std::string name = translated(style->name);
      const double width = textWidth(name, kSpectrumTextSize, false);
      addText(name, {x + kLegendLine + 5 + width / 2, y}, ColorRole::ink);
      x += kLegendLine + 5 + width + kLegendGap;
    }
    const std::string note = translated("Height and dashes tell what repeats, not how strongly.");
    addText(note, {textWidth(note, kSpectrumTextSize, false) / 2, y + 1.6 * kSpectrumTextSize});
  }

  const Mechanism& m_mechanism;
  const std::vector<FrequencyLine>& m_lines;
  int m_first = 0;
  int m_last = 1;
  double m_decade = kDecade;
  double m_labelTop = -150;
  std::vector<const LineStyle*> m_used;
  DisplayList m_list;
};

}  // namespace

DisplayList spectrumDrawing(const Mechanism& mechanism, const std::vector<FrequencyLine>& lines,
                            const std::string& xTitle, const std::string& without) {
  std::vector<FrequencyLine> drawn = lines;
  std::erase_if(drawn, [](const FrequencyLine& line) {  // beyond the range of doubles
    return !std::isfinite(std::log10(line.ratio.toDouble()));
  });
  if (!drawn.empty()) return SpectrumMaker(mechanism, drawn).make(xTitle);
  DisplayList empty;
  empty.marks.push_back({ElementId(), MarkRole::label, 0,
                         Text{without, {0, 0}, kSpectrumTextSize, false, ColorRole::secondary}});
  return empty;
}

}  // namespace geargraph
