#include "core/presentation/report/written_words.h"

#include <algorithm>

#include "core/presentation/report/report_words.h"
#include "core/presentation/typeset/tex_reader.h"

namespace geargraph {
namespace {

bool canBeSet(const std::string& tex) {
  return readTex(tex).fault.empty();
}

}  // namespace

ReportWords writtenWords(std::string_view sentence) {
  if (std::count(sentence.begin(), sentence.end(), '$') % 2 != 0) return plainWords(std::string(sentence));
  ReportWords words = reportWords(sentence);
  for (ReportSpan& span : words) {
    if (span.isFormula && !canBeSet(span.text)) span.isFormula = false;
  }
  return words;
}

void addWrittenFormula(std::vector<ReportBlock>& blocks, const std::string& tex, PaperEquation equation) {
  if (tex.empty()) return;
  if (!canBeSet(tex)) {
    blocks.emplace_back(ReportParagraph{plainWords(tex)});
    return;
  }
  ReportEquation set{tex, std::nullopt, {}};
  if (equation != PaperEquation::none) set.number = numberOf(equation);
  blocks.emplace_back(std::move(set));
}

}  // namespace geargraph
