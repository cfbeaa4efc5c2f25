// Tables of walks through the tree: Z, T, C and Q, whose entries are mistaken in the same ways.

#include <algorithm>

#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

constexpr int kMaxWidth = 16;  ///< columns of a row to fill in
constexpr int kBlock = 4;      ///< rows and columns of a block of Z
constexpr int kMaxTreeRows = 2;

/// A rectangle of a matrix as a question.
class WalkTable {
 public:
  WalkTable(const ExerciseSource& source, QuestionBuilder& build, MatrixKind kind, std::vector<int> rows,
            std::vector<int> columns)
      : m_build(build),
        m_matrix(*source.matrix(kind)),
        m_rows(std::move(rows)),
        m_columns(std::move(columns)) {
    std::vector<std::string> rowNames;
    std::vector<std::string> columnNames;
    for (const int row : m_rows) rowNames.push_back(m_matrix.rowHeading(row).text);
    for (const int column : m_columns) columnNames.push_back(m_matrix.columnHeading(column).text);
    build.table(rowNames, columnNames, FieldKind::integer);
    if (const auto parts = m_matrix.partition()) {
      const auto after = std::lower_bound(m_columns.begin(), m_columns.end(), *parts);
      if (after != m_columns.begin() && after != m_columns.end())
        build.question.table.partition = static_cast<int>(after - m_columns.begin());
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
      for (std::size_t j = 0; j < m_columns.size(); ++j) {
        const ElementId row = m_matrix.rowHeading(m_rows[i]).element;
        const ElementId column = m_matrix.columnHeading(m_columns[j]).element;
        auto& elements = build.question.fields[at(i, j)].elements;
        elements = {row};
        if (column != row) elements.push_back(column);  // of C and Q a row is named after one of its columns
      }
    }
    m_values = valuesOf(m_rows);
  }

  [[nodiscard]] const std::vector<int>& values() const { return m_values; }
  [[nodiscard]] std::size_t at(std::size_t row, std::size_t column) const {
    return row * m_columns.size() + column;
  }
  /// The same columns of other rows.
  [[nodiscard]] std::vector<int> valuesOf(const std::vector<int>& rows) const {
    std::vector<int> values;
    for (const int row : rows) {
      for (const int column : m_columns) values.push_back(m_matrix.entry(row, column));
    }
    return values;
  }
  [[nodiscard]] std::vector<int> fieldsOfRow(std::size_t row) const {
    std::vector<int> fields;
    for (std::size_t j = 0; j < m_columns.size(); ++j) fields.push_back(static_cast<int>(at(row, j)));
    return fields;
  }
  [[nodiscard]] std::vector<int> fieldsOfColumn(std::size_t column) const {
    std::vector<int> fields;
    for (std::size_t i = 0; i < m_rows.size(); ++i) fields.push_back(static_cast<int>(at(i, column)));
    return fields;
  }
  [[nodiscard]] ElementId columnElement(std::size_t column) const {
    return m_matrix.columnHeading(m_columns[column]).element;
  }

  /// The mistakes of an entry for a joint that is walked: its sign, left out, not on the walk.
  void addWalked(std::size_t row, std::size_t column, const std::string& walk, const std::string& joint,
                 const ElementId& element) {
    const int value = m_values[at(row, column)];
    const auto field = static_cast<int>(at(row, column));
    if (value == 0) {
      m_build.wrongField("joint-off-the-walk", field, {"1", "-1"},
                         translated("%1 does not use %2: 0.", {walk, joint}), {element});
      return;
    }
    const bool isAlong = value > 0;
    m_build.wrongField("walked-against-arrow", field, {asText(-value)},
                       isAlong ? translated("%1 runs along the arrow of %2: 1, not −1.", {walk, joint})
                               : translated("%1 runs against the arrow of %2: −1, not 1.", {walk, joint}),
                       {element});
    m_build.wrongField("joint-left-out", field, {"0"},
                       isAlong ? translated("%1 uses %2, along its arrow: 1, not 0.", {walk, joint})
                               : translated("%1 uses %2, against its arrow: −1, not 0.", {walk, joint}),
                       {element});
  }

 private:
  QuestionBuilder& m_build;
  const IntegerMatrix& m_matrix;
  std::vector<int> m_rows;
  std::vector<int> m_columns;
  std::vector<int> m_values;
};

/// The non-zero columns of these rows and others, at most kMaxWidth unless more are not zero.
std::vector<int> columnsFor(const IntegerMatrix& matrix, const std::vector<int>& rows,
                            ExerciseRandom& random) {
  std::vector<int> columns;
  std::vector<int> others;
  for (int column = 0; column < matrix.columns(); ++column) {
    const bool isUsed =
        std::any_of(rows.begin(), rows.end(), [&](int row) { return matrix.entry(row, column) != 0; });
    (isUsed ? columns : others).push_back(column);
  }
  const int room = std::max(0, kMaxWidth - static_cast<int>(columns.size()));
  for (const int column : random.someOf(others, room)) columns.push_back(column);
  std::sort(columns.begin(), columns.end());
  return columns;
}

std::string cycleName(const ExerciseSource& source, MeshOrdinal mesh) {
  return translated("The cycle of mesh %1", {source.meshLabel(mesh)});
}

/// Rows of T or C of these meshes.
void addCycleRows(const ExerciseSource& source, QuestionBuilder& build, WalkTable& table, MatrixKind kind,
                  const std::vector<int>& meshes, const std::vector<int>& columns) {
  const int t = source.graph().t();
  const auto width = columns.size();
  for (std::size_t row = 0; row < meshes.size(); ++row) {
    const std::string cycle = cycleName(source, meshes[row]);
    const auto begin = table.values().begin() + static_cast<std::ptrdiff_t>(row * width);
    const std::vector<int> right(begin, begin + static_cast<std::ptrdiff_t>(width));
    std::vector<int> backwards = negated(right);
    std::vector<int> walked = magnitudes(right);
    std::vector<std::vector<std::string>> allBackwards{asTexts(backwards)};
    for (std::size_t j = 0; j < width; ++j) {
      if (columns[j] >= t) backwards[j] = right[j];
    }
    allBackwards.push_back(asTexts(backwards));
    const std::vector<int> fields = table.fieldsOfRow(row);
    build.wrongFields("cycle-backwards", fields, allBackwards,
                      translated("You walk the cycle against mesh %1: it runs along the mesh from tail to "
                                 "head and back through the tree.",
                                 {source.meshLabel(meshes[row])}),
                      {source.meshId(meshes[row])});
    build.wrongFields("signs-left-out", fields, {asTexts(walked)},
                      translated("You mark the joints of the cycle without their senses: −1 where the walk "
                                 "runs against an arrow."),
                      {source.meshId(meshes[row])});
    for (int other = 0; other < source.graph().c(); ++other) {
      if (other == meshes[row]) continue;
      build.wrongFields("another-cycle", fields, {asTexts(table.valuesOf({other}))},
                        translated("This is the row of the cycle of mesh %1, not of mesh %2.",
                                   {source.meshLabel(other), source.meshLabel(meshes[row])}),
                        {source.meshId(other)});
    }
    for (std::size_t j = 0; j < width; ++j) {
      const auto field = static_cast<int>(table.at(row, j));
      if (columns[j] < t) {
        table.addWalked(row, j, cycle, edgeName(source, columns[j]), source.edgeId(columns[j]));
      } else if (columns[j] - t == meshes[row] && kind == MatrixKind::cycleBasis) {
        build.wrongField("own-mesh-left-out", field, {"0"},
                         translated("%1 begins along the mesh itself: 1.", {cycle}),
                         {source.edgeId(columns[j])});
        build.wrongField("cycle-backwards", field, {"-1"},
                         translated("%1 is walked along its mesh, from tail to head: 1, not −1.", {cycle}),
                         {source.edgeId(columns[j])});
      } else {
        build.wrongField(
            "another-mesh-in-cycle", field, {"1", "-1"},
            translated("%1 holds one mesh only, not mesh %2: 0.", {cycle, source.edgeLabel(columns[j])}),
            {source.edgeId(columns[j])});
      }
    }
  }
  build.wrongNonSigns();
}

Question pathQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const SpanningTree& tree = *source.tree();
  const int size = std::min(kBlock, source.graph().n());
  std::vector<int> links = random.someOf(firstNumbers(source.graph().n()), size);  // columns: link - 1
  std::vector<int> onWalks;
  std::vector<int> others;
  for (JointOrdinal joint = 0; joint < source.graph().t(); ++joint) {
    const bool isUsed =
        std::any_of(links.begin(), links.end(), [&](int column) { return tree.isOnWalk(joint, column + 1); });
    (isUsed ? onWalks : others).push_back(joint);
  }
  std::vector<int> joints = random.someOf(onWalks, size);
  for (const JointOrdinal joint : random.someOf(others, size - static_cast<int>(joints.size())))
    joints.push_back(joint);
  std::sort(joints.begin(), joints.end());

  QuestionBuilder build(ExerciseKind::path, 4);
  build.question.prompt = translated(
      "Fill in these rows and columns of the path matrix $Z$: how the walk from each link to the ground uses "
      "the turning joints.");
  build.question.rule = translated(
      "Walk from the link to the ground: 1 where the walk follows a joint's arrow, −1 where it runs against "
      "it, 0 off the walk.");
  WalkTable table(source, build, MatrixKind::path, joints, links);
  const std::vector<int>& values = table.values();
  build.accept(asTexts(values));
  build.wrong("walk-from-ground", asTexts(negated(values)),
              translated("You walk from the ground to the links: the walks of Z end at the ground."),
              {source.linkId(0)});
  build.wrong(
      "signs-left-out", asTexts(magnitudes(values)),
      translated(
          "You mark the joints of the walks without their senses: −1 where a walk runs against an arrow."));
  std::vector<int> transposed;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    for (std::size_t j = 0; j < links.size(); ++j) transposed.push_back(values[table.at(j, i)]);
  }
  build.wrong(
      "transposed", asTexts(transposed),
      translated("You exchange rows and columns: a column of Z belongs to a link and tells its walk."));
  for (std::size_t j = 0; j < links.size(); ++j) {
    const LinkOrdinal node = links[j] + 1;
    for (int other = 1; other < source.graph().nodeCount(); ++other) {
      if (other == node) continue;
      std::vector<int> column;
      for (const JointOrdinal joint : joints) column.push_back(tree.pathEntry(joint, other));
      if (std::count(column.begin(), column.end(), 0) == static_cast<std::ptrdiff_t>(column.size())) continue;
      build.wrongFields("another-link", table.fieldsOfColumn(j), {asTexts(column)},
                        translated("This is the walk of link %1, not of link %2.",
                                   {source.linkLabel(other), source.linkLabel(node)}),
                        {source.linkId(node), source.linkId(other)});
    }
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    for (std::size_t j = 0; j < links.size(); ++j) {
      table.addWalked(i, j,
                      translated("The walk from link %1 to the ground", {source.linkLabel(links[j] + 1)}),
                      edgeName(source, joints[i]), source.edgeId(joints[i]));
    }
  }
  build.wrongNonSigns();
  return std::move(build.question);
}

Question treeMatrixQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const std::vector<int> meshes = random.someOf(firstNumbers(source.graph().c()), kMaxTreeRows);
  const std::vector<int> columns = columnsFor(*source.matrix(MatrixKind::spanningTree), meshes, random);
  QuestionBuilder build(ExerciseKind::treeMatrix, 4);
  build.question.prompt = meshes.size() == 1
                              ? translated("Fill in this row of the spanning-tree matrix $T$.")
                              : translated("Fill in these rows of the spanning-tree matrix $T$.");
  build.question.rule = translated(
      "Walk the cycle along its mesh from tail to head and back through the tree: 1 where the walk follows a "
      "joint's arrow, −1 where it runs against it.");
  WalkTable table(source, build, MatrixKind::spanningTree, meshes, columns);
  build.accept(asTexts(table.values()));
  build.wrong("cycle-backwards", asTexts(negated(table.values())),
              translated("You walk the cycles against their meshes: they run along the mesh from tail to "
                         "head and back through the tree."));
  build.wrong("signs-left-out", asTexts(magnitudes(table.values())),
              translated("You mark the joints of the cycles without their senses: −1 where the walk runs "
                         "against an arrow."));
  if (meshes.size() == 2) {
    build.wrong("another-cycle", asTexts(table.valuesOf({meshes[1], meshes[0]})),
                translated("You exchange the rows of both cycles."),
                {source.meshId(meshes[0]), source.meshId(meshes[1])});
  }
  addCycleRows(source, build, table, MatrixKind::spanningTree, meshes, columns);
  return std::move(build.question);
}

Question cycleBasisQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const std::vector<int> meshes{random.below(source.graph().c())};
  const std::vector<int> columns = columnsFor(*source.matrix(MatrixKind::cycleBasis), meshes, random);
  QuestionBuilder build(ExerciseKind::cycleBasis, 4);
  build.question.prompt =
      translated("Fill in row $C_{%1}$ of the cycle-basis matrix $C = \\left[ T \\mid U \\right]$.",
                 {source.meshLabel(meshes.front())});
  build.question.elements = {source.meshId(meshes.front())};
  build.question.rule = translated(
      "Walk the cycle along its mesh from tail to head and back through the tree: 1 where the walk follows "
      "an arrow, −1 where it runs against one.");
  WalkTable table(source, build, MatrixKind::cycleBasis, meshes, columns);
  build.accept(asTexts(table.values()));
  addCycleRows(source, build, table, MatrixKind::cycleBasis, meshes, columns);
  return std::move(build.question);
}

Question cutsetQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const int t = source.graph().t();
  const JointOrdinal joint = random.below(t);
  const IntegerMatrix& cutsets = *source.matrix(MatrixKind::cutset);
  const std::vector<int> columns = columnsFor(cutsets, {joint}, random);
  const std::string name = edgeName(source, joint);
  QuestionBuilder build(ExerciseKind::cutset, 4);
  build.question.prompt = translated(
      "Fill in the row of joint $%1$ of the fundamental cutset matrix $Q = \\left[ U \\mid -T^T \\right]$.",
      {source.edgeLabel(joint)});
  build.question.elements = {source.edgeId(joint)};
  build.question.rule = translated(
      "Without the joint the tree falls into two halves: every edge between them counts, 1 where it crosses "
      "in the joint's direction, −1 where it crosses the other way.");
  WalkTable table(source, build, MatrixKind::cutset, {joint}, columns);
  const std::vector<int>& values = table.values();
  build.accept(asTexts(values));
  std::vector<int> asCycles = values;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (columns[j] >= t) asCycles[j] = -values[j];
  }
  build.wrong("cutset-as-cycle", asTexts(asCycles),
              translated("You take the signs of the cycles: Q holds −T transposed beside the unit matrix."),
              {source.edgeId(joint)});
  build.wrong("signs-left-out", asTexts(magnitudes(values)),
              translated("You mark the edges of the cutset without their senses: −1 where an edge crosses "
                         "against the joint."),
              {source.edgeId(joint)});
  for (int other = 0; other < t; ++other) {
    if (other == joint) continue;
    build.wrong("another-joint", asTexts(table.valuesOf({other})),
                translated("This is the cutset of joint %1, not of %2.", {source.edgeLabel(other), name}),
                {source.edgeId(other)});
  }
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const auto field = static_cast<int>(j);
    const std::string edge = edgeName(source, columns[j]);
    const std::vector<ElementId> elements{source.edgeId(columns[j])};
    if (columns[j] == joint) {
      build.wrongField("crosses-backwards", field, {"-1"},
                       translated("The joint crosses its own cut in its own direction: 1, not −1."),
                       elements);
      build.wrongField("joint-left-out", field, {"0"},
                       translated("The cutset holds its own joint: 1, not 0."), elements);
    } else if (values[j] == 0 && columns[j] < t) {
      build.wrongField("joint-in-cutset", field, {"1", "-1"},
                       translated("A fundamental cutset holds one turning joint only, not %1: 0.", {edge}),
                       elements);
    } else if (values[j] == 0) {
      build.wrongField("mesh-not-cut", field, {"1", "-1"},
                       translated("Both gears of %1 are on one side of %2: 0.", {edge, name}), elements);
    } else {
      build.wrongField(
          "crosses-backwards", field, {asText(-values[j])},
          values[j] > 0
              ? translated("The arrow of %1 crosses the cut in the direction of %2: 1, not −1.", {edge, name})
              : translated("The arrow of %1 crosses the cut against %2: −1, not 1.", {edge, name}),
          elements);
      build.wrongField("mesh-not-counted", field, {"0"},
                       translated("The ends of %1 are on different sides of %2: %3, not 0.",
                                  {edge, name, inWords(values[j])}),
                       elements);
    }
  }
  build.wrongNonSigns();
  return std::move(build.question);
}

}  // namespace

ExerciseEntry pathEntry() {
  return {.kind = ExerciseKind::path,
          .name = "path",
          .title = toTranslate("Fill in Z"),
          .hint = toTranslate(
              "Start at the link of the column and walk to the ground along turning joints only. Then "
              "compare the arrow of each joint on the walk with your direction."),
          .lack = withoutTree,
          .make = pathQuestion};
}

ExerciseEntry treeMatrixEntry() {
  return {.kind = ExerciseKind::treeMatrix,
          .name = "tree-matrix",
          .title = toTranslate("Fill in T"),
          .hint = toTranslate(
              "Keep the turning joints and only the mesh of the row: together they close one cycle. Begin "
              "along the mesh, from tail to head, and compare each arrow on the way back with your "
              "direction."),
          .lack = withoutMeshes,
          .make = treeMatrixQuestion};
}

ExerciseEntry cycleBasisEntry() {
  return {.kind = ExerciseKind::cycleBasis,
          .name = "cycle-basis",
          .title = toTranslate("Fill in a row of C"),
          .hint = toTranslate(
              "Begin with the columns of the meshes: a cycle of the basis holds one mesh, its own. Then "
              "walk from the head of the mesh back to its tail along turning joints."),
          .lack = withoutMeshes,
          .make = cycleBasisQuestion};
}

ExerciseEntry cutsetEntry() {
  return {.kind = ExerciseKind::cutset,
          .name = "cutset",
          .title = toTranslate("Fill in a row of Q"),
          .hint = toTranslate(
              "Without the joint the turning joints fall into two groups of links. Look for edges with "
              "one end in each group, and compare their direction with that of the joint."),
          .lack = withoutMeshes,
          .make = cutsetQuestion};
}

}  // namespace geargraph
