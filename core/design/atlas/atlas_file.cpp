#include "core/design/atlas/atlas_file.h"

#include <algorithm>
#include <charconv>

#include "core/design/atlas/bundled_atlas.h"
#include "core/design/atlas/chain_enumeration.h"
#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr std::string_view kAtlasHead = "geargraph-atlas 1";

/// Takes the whole number at the front of `text`; std::nullopt if there is none above 0 or it is very large.
std::optional<int> takeNumber(std::string_view& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end == text.data() || value < 0 || value > 1'000'000) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

bool takeSign(std::string_view& text, char sign) {
  if (text.empty() || text.front() != sign) return false;
  text.remove_prefix(1);
  return true;
}

std::string_view takeWord(std::string_view& text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

/// A link of a file, 1 to 9, as an index; -1 if it is none of the chain's.
int linkOf(char digit, int links) {
  const int link = digit - '1';
  return link >= 0 && link < links ? link : -1;
}

/// "123/14/25": false unless the incidence of links and axes is a tree.
bool readAxes(std::string_view word, Chain& chain) {
  std::size_t incidences = 0;
  chain.axes.emplace_back();
  for (const char c : word) {
    if (c == '/') {
      chain.axes.emplace_back();
      continue;
    }
    const int link = linkOf(c, chain.links);
    std::vector<int>& axis = chain.axes.back();
    if (link < 0 || (!axis.empty() && axis.back() >= link)) return false;
    axis.push_back(link);
    ++incidences;
  }
  for (const std::vector<int>& axis : chain.axes)
    if (axis.size() < 2) return false;
  // A graph is a tree if it is connected and has one edge less than vertices.
  std::vector<bool> isReached(static_cast<std::size_t>(chain.links));
  isReached[0] = true;
  for (std::size_t round = 0; round < chain.axes.size(); ++round) {
    for (const std::vector<int>& axis : chain.axes) {
      if (std::none_of(axis.begin(), axis.end(),
                       [&](int l) { return isReached[static_cast<std::size_t>(l)]; }))
        continue;
      for (const int link : axis) isReached[static_cast<std::size_t>(link)] = true;
    }
  }
  return incidences + 1 == chain.axes.size() + static_cast<std::size_t>(chain.links) &&
         std::find(isReached.begin(), isReached.end(), false) == isReached.end();
}

/// "241/341": gear, gear and carrier of each pair.
bool readMeshes(std::string_view word, Chain& chain) {
  const std::vector<ChainMesh> possible = possibleMeshes(chain);
  while (!word.empty()) {
    if (word.size() < 3) return false;
    const ChainMesh mesh{linkOf(word[0], chain.links), linkOf(word[1], chain.links),
                         linkOf(word[2], chain.links)};
    if (std::find(possible.begin(), possible.end(), mesh) == possible.end()) return false;
    chain.meshes.push_back(mesh);
    word.remove_prefix(3);
    if (!word.empty() && !takeSign(word, '/')) return false;
  }
  return true;
}

/// "6-1.5.1 1236/14/25 241/341"; std::nullopt if the line is no chain.
std::optional<AtlasChain> readChainLine(std::string_view line) {
  const auto number = ChainNumber::fromText(takeWord(line));
  if (!number || number->displacement == 0 || number->links < 3 || number->links > 9) return std::nullopt;
  AtlasChain chain{*number, {number->links, {}, {}}};
  if (!readAxes(takeWord(line), chain.chain) || !readMeshes(takeWord(line), chain.chain)) return std::nullopt;
  if (!line.empty() || chain.chain.dof() != number->dof) return std::nullopt;
  return chain;
}

/// Numbers count on without gaps, sections come in their order.
bool comesNext(const ChainNumber& last, const ChainNumber& next) {
  const ChainNumber group{last.links, last.dof, last.rotation, last.displacement + 1};
  const ChainNumber section{last.links, last.dof, last.rotation + 1, 1};
  const bool isNewSection = std::pair(next.links, next.dof) > std::pair(last.links, last.dof);
  return next == group || next == section || (isNewSection && next.rotation == 1 && next.displacement == 1);
}

Diagnostic atlasFault(int line, std::string message) {
  Diagnostic fault{line == 1 ? Code::format : Code::syntax, std::move(message), {}, {}};
  fault.line = line;
  fault.column = 1;
  return fault;
}

void writeChainLine(const ChainNumber& number, const Chain& chain, std::string& text) {
  const auto digit = [](int link) { return static_cast<char>('1' + link); };
  text += number.toString();
  char separator = ' ';
  for (const std::vector<int>& axis : chain.axes) {
    text += separator;
    separator = '/';
    for (const int link : axis) text += digit(link);
  }
  separator = ' ';
  for (const ChainMesh& mesh : chain.meshes) {
    text += separator;
    separator = '/';
    for (const int link : {mesh.tail, mesh.head, mesh.carrier}) text += digit(link);
  }
  text += '\n';
}

}  // namespace

std::string ChainNumber::toString() const {
  std::string text = std::to_string(links) + '-' + std::to_string(dof) + '.' + std::to_string(rotation);
  if (displacement > 0) text += '.' + std::to_string(displacement);
  return text;
}

std::optional<ChainNumber> ChainNumber::fromText(std::string_view text) {
  const auto links = takeNumber(text);
  if (!links || !takeSign(text, '-')) return std::nullopt;
  const auto dof = takeNumber(text);
  if (!dof || !takeSign(text, '.')) return std::nullopt;
  const auto rotation = takeNumber(text);
  if (!rotation || *rotation == 0) return std::nullopt;
  if (text.empty()) return ChainNumber{*links, *dof, *rotation, 0};
  if (!takeSign(text, '.')) return std::nullopt;
  const auto displacement = takeNumber(text);
  if (!displacement || *displacement == 0 || !text.empty()) return std::nullopt;
  return ChainNumber{*links, *dof, *rotation, *displacement};
}

const Atlas& Atlas::shipped() {
  static const Atlas atlas = [] {
    const std::span<const unsigned char> bytes = atlasFiles().front();
    return read({reinterpret_cast<const char*>(bytes.data()), bytes.size()}).value();
  }();
  return atlas;
}

Expected<Atlas> Atlas::read(std::string_view text) {
  Atlas atlas;
  int lineNumber = 0;
  while (!text.empty()) {
    ++lineNumber;
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (lineNumber == 1) {
      if (line != kAtlasHead) return atlasFault(1, translated("This is no atlas of chains."));
      continue;
    }
    auto chain = readChainLine(line);
    if (!chain)
      return atlasFault(lineNumber, translated("This line of the atlas is no chain with its number."));
    const ChainNumber last = atlas.m_chains.empty() ? ChainNumber() : atlas.m_chains.back().number;
    ChainNumber group = chain->number;
    group.displacement = 0;
    const auto [rotation, isNewRotation] = atlas.m_rotations.try_emplace(rotationForm(chain->chain), group);
    const bool isNew =
        atlas.m_displacements.try_emplace(displacementForm(chain->chain), chain->number).second;
    if (!comesNext(last, chain->number) || rotation->second != group || !isNew ||
        isNewRotation != (chain->number.displacement == 1))
      return atlasFault(lineNumber, translated("Chain %1 is not at its place in the atlas, or there twice.",
                                               {chain->number.toString()}));
    atlas.m_chains.push_back(std::move(*chain));
  }
  if (lineNumber == 0) return atlasFault(1, translated("This is no atlas of chains."));
  return atlas;
}

std::span<const AtlasChain> Atlas::chains(int links, int dof) const {
  const auto section = [&](const AtlasChain& chain) {
    return std::pair(chain.number.links, chain.number.dof) < std::pair(links, dof);
  };
  const auto first = std::partition_point(m_chains.begin(), m_chains.end(), section);
  const auto end = std::find_if(first, m_chains.end(), [&](const AtlasChain& chain) {
    return chain.number.links != links || chain.number.dof != dof;
  });
  return {first, end};
}

std::span<const AtlasChain> Atlas::group(const ChainNumber& number) const {
  const std::span<const AtlasChain> section = chains(number.links, number.dof);
  const auto isOfGroup = [&](const AtlasChain& chain) { return chain.number.rotation == number.rotation; };
  const auto first = std::find_if(section.begin(), section.end(), isOfGroup);
  return {first, std::find_if_not(first, section.end(), isOfGroup)};
}

const AtlasChain* Atlas::find(const ChainNumber& number) const {
  const auto found =
      std::lower_bound(m_chains.begin(), m_chains.end(), number,
                       [](const AtlasChain& chain, const ChainNumber& n) { return chain.number < n; });
  return found != m_chains.end() && found->number == number ? &*found : nullptr;
}

std::optional<ChainNumber> Atlas::numberOf(const Chain& chain) const {
  const auto found = m_displacements.find(displacementForm(chain));
  return found == m_displacements.end() ? std::nullopt : std::optional(found->second);
}

std::optional<ChainNumber> Atlas::rotationNumberOf(const Chain& chain) const {
  const auto found = m_rotations.find(rotationForm(chain));
  return found == m_rotations.end() ? std::nullopt : std::optional(found->second);
}

int Atlas::mostLinks(int dof) const {
  int most = 0;
  for (const AtlasChain& chain : m_chains)
    if (chain.number.dof == dof) most = std::max(most, chain.number.links);
  return most;
}

ChainCounts countsOf(std::span<const AtlasChain> chains) {
  ChainCounts counts{0, static_cast<int>(chains.size())};
  for (std::size_t i = 0; i < chains.size(); ++i) {
    ChainNumber before = i == 0 ? ChainNumber() : chains[i - 1].number;
    before.displacement = chains[i].number.displacement;
    counts.rotations += before == chains[i].number ? 0 : 1;
  }
  return counts;
}

std::string atlasText(int mostLinks, const std::stop_token& stop) {
  std::string text = std::string(kAtlasHead) + '\n';
  for (int links = 3; links <= mostLinks; ++links) {
    for (int dof = 0; dof <= std::min(2, links - 2); ++dof) {
      if (dof == 0 && links < 4) continue;
      const auto groups = dof == 0 ? enumerateLockedChains(links, stop) : enumerateChains(links, dof, stop);
      for (std::size_t g = 0; g < groups.size(); ++g) {
        for (std::size_t d = 0; d < groups[g].size(); ++d)
          writeChainLine({links, dof, static_cast<int>(g) + 1, static_cast<int>(d) + 1}, groups[g][d], text);
      }
    }
  }
  return stop.stop_requested() ? std::string() : text;
}

std::string axesText(const Chain& chain) {
  std::string text;
  for (const std::vector<int>& axis : chain.axes) {
    if (!text.empty()) text += ' ';
    for (std::size_t i = 0; i < axis.size(); ++i) text += (i == 0 ? "" : ",") + std::to_string(axis[i] + 1);
  }
  return text;
}

std::string meshesText(const Chain& chain) {
  std::string text;
  for (const ChainMesh& mesh : chain.meshes) {
    text += (text.empty() ? "" : " ") + std::to_string(mesh.tail + 1) + '-' + std::to_string(mesh.head + 1) +
            '/' + std::to_string(mesh.carrier + 1);
  }
  return text;
}

}  // namespace geargraph
