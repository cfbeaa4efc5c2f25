// Incidence matrices and the orientation of the digraph.

#include <algorithm>

#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

constexpr int kMaxAskedEdges = 4;
constexpr int kMaxRows = 12;

/// Some edges, one mesh among them where there is one, ascending.
std::vector<int> someEdges(const ExerciseSource& source, ExerciseRandom& random) {
  const Digraph& graph = source.graph();
  std::vector<int> edges = random.someOf(firstNumbers(graph.edgeCount()), kMaxAskedEdges);
  if (graph.c() > 0 && edges.back() < graph.t()) edges.back() = graph.t() + random.below(graph.c());
  return edges;
}

/// The links of the rows: all, or of a large mechanism the ground, the ends of the edges and some others.
std::vector<int> rowsFor(const ExerciseSource& source, const std::vector<int>& edges,
                         ExerciseRandom& random) {
  const Digraph& graph = source.graph();
  std::vector<int> rows{0};
  for (const int edge : edges) {
    rows.push_back(graph.edge(edge).tail);
    rows.push_back(graph.edge(edge).head);
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  std::vector<int> others;
  for (LinkOrdinal node = 0; node < graph.nodeCount(); ++node) {
    if (!std::binary_search(rows.begin(), rows.end(), node)) others.push_back(node);
  }
  for (const LinkOrdinal node : random.someOf(others, kMaxRows - static_cast<int>(rows.size())))
    rows.push_back(node);
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// A table of links over edges, and what is usually mistaken in it.
class IncidenceTable {
 public:
  IncidenceTable(const ExerciseSource& source, QuestionBuilder& build, ExerciseRandom& random)
      : m_source(source),
        m_build(build),
        m_edges(someEdges(source, random)),
        m_rows(rowsFor(source, m_edges, random)) {
    std::vector<std::string> rows;
    std::vector<std::string> columns;
    for (const LinkOrdinal node : m_rows) rows.push_back(source.linkLabel(node));
    for (const int edge : m_edges) columns.push_back(source.edgeLabel(edge));
    build.table(rows, columns, FieldKind::integer);
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
      for (std::size_t column = 0; column < m_edges.size(); ++column)
        m_build.question.fields[at(row, column)].elements = {source.linkId(m_rows[row]),
                                                             source.edgeId(m_edges[column])};
    }
    for (const LinkOrdinal node : m_rows) {
      for (const int edge : m_edges) m_values.push_back(entry(node, edge));
    }
  }

  [[nodiscard]] const std::vector<int>& values() const { return m_values; }
  [[nodiscard]] std::size_t width() const { return m_edges.size(); }

  /// Of columns and entries. From the row `first` on.
  void addMistakes(std::size_t first) {
    for (std::size_t column = 0; column < m_edges.size(); ++column) addColumn(first, column);
    for (std::size_t row = first; row < m_rows.size(); ++row) {
      for (std::size_t column = 0; column < m_edges.size(); ++column) addEntry(row, column);
    }
  }

 private:
  [[nodiscard]] std::size_t at(std::size_t row, std::size_t column) const { return row * width() + column; }
  [[nodiscard]] int entry(LinkOrdinal node, int edge) const {
    const DigraphEdge& ends = m_source.graph().edge(edge);
    return node == ends.head ? 1 : node == ends.tail ? -1 : 0;
  }
  [[nodiscard]] std::string arrow(int edge) const {
    const DigraphEdge& ends = m_source.graph().edge(edge);
    return translated("from link %1 to link %2",
                      {m_source.linkLabel(ends.tail), m_source.linkLabel(ends.head)});
  }

  void addColumn(std::size_t first, std::size_t column) {
    const int edge = m_edges[column];
    std::vector<int> fields;
    std::vector<int> values;
    for (std::size_t row = first; row < m_rows.size(); ++row) {
      fields.push_back(static_cast<int>(at(row, column)));
      values.push_back(-m_values[at(row, column)]);
    }
    m_build.wrongFields(
        "arrow-reversed", fields, {asTexts(values)},
        translated("You turn the arrow of %1 round: it points %2.", {edgeName(m_source, edge), arrow(edge)}),
        {m_source.edgeId(edge)});
  }

  void addEntry(std::size_t row, std::size_t column) {
    const int edge = m_edges[column];
    const LinkOrdinal node = m_rows[row];
    const int value = m_values[at(row, column)];
    const auto field = static_cast<int>(at(row, column));
    const std::vector<ElementId> elements{m_source.linkId(node), m_source.edgeId(edge)};
    const std::string link = m_source.linkLabel(node);
    const std::string name = edgeName(m_source, edge);
    if (value == 0) {
      m_build.wrongField(
          "not-an-end", field, {"1", "-1"},
          translated("You give link %1 an end of %2, but its arrow points %3: 0.", {link, name, arrow(edge)}),
          elements);
      return;
    }
    m_build.wrongField("end-left-out", field, {"0"},
                       value > 0 ? translated("The arrow of %1 ends at link %2: 1, not 0.", {name, link})
                                 : translated("The arrow of %1 begins at link %2: −1, not 0.", {name, link}),
                       elements);
    m_build.wrongField("arrow-reversed", field, {asText(-value)},
                       value > 0 ? translated("The arrow of %1 ends at link %2: 1, not −1.", {name, link})
                                 : translated("The arrow of %1 begins at link %2: −1, not 1.", {name, link}),
                       elements);
  }

  const ExerciseSource& m_source;
  QuestionBuilder& m_build;
  std::vector<int> m_edges;
  std::vector<int> m_rows;  ///< nodes; the ground first
  std::vector<int> m_values;
};

constexpr const char* kExchanged =
    toTranslate("You exchange + and −: a column holds −1 where the arrow begins and 1 where it ends.");
constexpr const char* kUnsigned =
    toTranslate("You mark both ends alike: the end where the arrow begins is −1, the one where it ends 1.");

Question incidenceQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  QuestionBuilder build(ExerciseKind::incidence, 4);
  IncidenceTable table(source, build, random);
  build.question.prompt = translated("Fill in these columns of the incidence matrix $\\Gamma^0$.");
  build.question.rule = translated(
      "A column of Γ⁰ holds −1 in the row of the link where the arrow begins, 1 where it ends, and 0 "
      "elsewhere.");
  const std::vector<int>& values = table.values();
  build.accept(asTexts(values));
  build.wrong("incidence-exchanged", asTexts(negated(values)), translated(kExchanged));
  build.wrong("signs-left-out", asTexts(magnitudes(values)), translated(kUnsigned));
  std::vector<int> ground;
  std::vector<std::string> zeros;
  for (std::size_t i = 0; i < table.width(); ++i) {
    ground.push_back(static_cast<int>(i));
    zeros.emplace_back("0");
  }
  if (std::count(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(table.width()), 0) <
      static_cast<std::ptrdiff_t>(table.width()) - 1) {
    build.wrongFields("ground-row-left-out", ground, {zeros},
                      translated("You leave out the ground: Γ⁰ keeps its row, only Γ has none."),
                      {source.linkId(0)});
  }
  table.addMistakes(0);
  build.wrongNonSigns();
  return std::move(build.question);
}

Question reducedIncidenceQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  QuestionBuilder build(ExerciseKind::reducedIncidence, 4);
  IncidenceTable table(source, build, random);
  build.question.prompt = translated(
      "Fill in these columns of the reduced incidence matrix $\\Gamma$. Leave a row that $\\Gamma$ does not "
      "have empty.");
  build.question.rule = translated(
      "Γ is Γ⁰ without the row of the ground, so that its rows are independent; all other entries stay.");
  std::vector<std::string> values = asTexts(table.values());
  std::vector<std::string> withGround = values;
  std::vector<std::string> exchanged = asTexts(negated(table.values()));
  std::vector<std::string> unsignedValues = asTexts(magnitudes(table.values()));
  std::vector<int> ground;
  for (std::size_t i = 0; i < table.width(); ++i) {
    ground.push_back(static_cast<int>(i));
    build.question.fields[i].mayBeEmpty = true;
    for (auto* row : {&values, &exchanged, &unsignedValues}) (*row)[i].clear();
  }
  build.accept(values);
  build.wrong("ground-row-left-in", withGround,
              translated("You leave the row of the ground in: Γ has the rows of the moving links only."),
              {source.linkId(0)});
  build.wrong("incidence-exchanged", exchanged, translated(kExchanged));
  build.wrong("signs-left-out", unsignedValues, translated(kUnsigned));
  for (const int field : ground) {
    build.wrongIf("ground-row-left-in", {{Test::differs, {field}, {{""}}}},
                  translated("You fill in the row of the ground: Γ has the rows of the moving links only."),
                  {source.linkId(0)}, {field});
  }
  table.addMistakes(1);
  build.wrongNonSigns();
  return std::move(build.question);
}

Question orientationQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const Digraph& graph = source.graph();
  QuestionBuilder build(ExerciseKind::orientation, 2);
  const std::vector<int> edges = someEdges(source, random);
  std::vector<std::string> rows;
  std::vector<std::string> right;
  std::vector<std::string> reversed;
  std::string head = "\\begin{array}{c|";
  std::string body;
  std::vector<DigraphEdge> drawn;  // other arrows than those of the mechanism, which its drawing shows
  for (const int edge : edges) {
    const DigraphEdge& own = graph.edge(edge);
    drawn.push_back(random.below(2) == 0 ? own : DigraphEdge{own.head, own.tail});
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const int edge = edges[i];
    head += 'r';
    body += " & " + source.edgeLabel(edge);
    rows.push_back(source.edgeLabel(edge));
    const DigraphEdge& ends = drawn[i];
    for (const LinkOrdinal node : {ends.tail, ends.head}) right.push_back(source.linkLabel(node));
    for (const LinkOrdinal node : {ends.head, ends.tail}) reversed.push_back(source.linkLabel(node));
  }
  body += " \\\\ \\hline\n";
  std::vector<std::string> links;
  for (LinkOrdinal node = 0; node < graph.nodeCount(); ++node) {
    links.push_back(source.linkLabel(node));
    body += source.linkLabel(node);
    for (const DigraphEdge& ends : drawn) {
      body += " & " + asText(node == ends.head ? 1 : node == ends.tail ? -1 : 0);
    }
    body += node + 1 < graph.nodeCount() ? " \\\\\n" : "\n";
  }
  build.question.formula = head + "}\n" + body + "\\end{array}";
  build.question.prompt = translated(
      "The mechanism is drawn with other arrows: these are columns of its incidence matrix $\\Gamma^0$. From "
      "which link to which link do they point?");
  build.question.rule =
      translated("An arrow begins at the link whose entry is −1 and ends at the link whose entry is 1.");
  build.table(rows, {toTranslate("from"), toTranslate("to")}, FieldKind::choice);
  for (std::size_t i = 0; i < build.question.fields.size(); ++i) {
    build.question.fields[i].options = links;
    build.question.fields[i].elements = {source.edgeId(edges[i / 2])};
  }
  build.accept(right);
  build.wrong("incidence-exchanged", reversed,
              translated("You turn every arrow round: −1 is where an arrow begins, 1 where it ends."));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::vector<ElementId> elements{source.edgeId(edges[i])};
    const auto from = static_cast<int>(2 * i);
    const std::string name = edgeName(source, edges[i]);
    build.wrongFields(
        "arrow-reversed", {from, from + 1}, {{right[2 * i + 1], right[2 * i]}},
        translated("You turn the arrow of %1 round: it begins at link %2, where the entry is −1.",
                   {name, right[2 * i]}),
        elements);
    for (const int field : {from, from + 1}) {
      build.wrongIf("not-an-end", {{Test::differs, {field}, {{right[2 * i]}, {right[2 * i + 1]}}}},
                    field == from
                        ? translated("The link that you name as the beginning of %1 has a 0 in column %2.",
                                     {name, source.edgeLabel(edges[i])})
                        : translated("The link that you name as the end of %1 has a 0 in column %2.",
                                     {name, source.edgeLabel(edges[i])}),
                    elements, {field});
    }
  }
  return std::move(build.question);
}

}  // namespace

ExerciseEntry incidenceEntry() {
  return {.kind = ExerciseKind::incidence,
          .name = "incidence",
          .title = toTranslate("Fill in Γ⁰"),
          .hint = toTranslate(
              "Take one column at a time. Its arrow touches two links only: the one that it leaves gets "
              "−1, the one that it points to gets 1."),
          .lack = withoutEdges,
          .make = incidenceQuestion};
}

ExerciseEntry orientationEntry() {
  return {.kind = ExerciseKind::orientation,
          .name = "orientation",
          .title = toTranslate("Orient the digraph"),
          .hint = toTranslate(
              "Read the matrix, not the drawing, one column at a time: the arrow leaves the link whose "
              "entry is −1 and points to the link whose entry is 1."),
          .lack = withoutEdges,
          .make = orientationQuestion};
}

ExerciseEntry reducedIncidenceEntry() {
  return {.kind = ExerciseKind::reducedIncidence,
          .name = "reduced-incidence",
          .title = toTranslate("Fill in Γ"),
          .hint = toTranslate(
              "All speeds are measured against one link: Γ leaves out its row. The other rows are "
              "those of Γ⁰."),
          .lack = withoutEdges,
          .make = reducedIncidenceQuestion};
}

}  // namespace geargraph
