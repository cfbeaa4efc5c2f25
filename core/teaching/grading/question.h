#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/foundations/base/id.h"
#include "core/teaching/grading/number_text.h"

namespace geargraph {

/// The type of a field: an integer, a rational number, one of its options, or a set of its options.
enum class FieldKind { integer, number, choice, set };

/// A blank to be filled in. Answers are texts, one for each field of the question, in order.
struct AnswerField {
  std::string name;  ///< unique in the question: "C16,10", "rank"
  FieldKind kind = FieldKind::integer;
  std::vector<std::string> options = {};  ///< for a choice or a set
  std::vector<ElementId> elements = {};   ///< that are highlighted with the field
  bool mayBeEmpty = false;                ///< an empty field is a valid answer
  std::string title = {};  ///< displayed instead of the name in the current language, if different; not
                           ///< stored in files
  std::string unit = {};   ///< that may follow a number: "rad/s"
  [[nodiscard]] const std::string& shownName() const { return title.empty() ? name : title; }
  friend bool operator==(const AnswerField&, const AnswerField&) = default;
};

/// The tests by which accepted answers and mistakes are defined. A test uses `values` of its condition:
enum class Test {
  values,        ///< the fields equal one of the rows
  differs,       ///< the fields can be parsed, and equal none of the rows
  multiple,      ///< the fields are a multiple, not by 0, of the only row
  rows,          ///< the fields, cut into rows, are the rows in any order, each up to its sign
  spanningTree,  ///< for a set of edges; rows {edge, node, node}: it is a spanning tree of this graph
  hasLoop,       ///< the same graph: some edges of the set close a loop
  basis,         ///< rows {name, numbers ...}: the rows named by the set are a regular square matrix
  dependent,     ///< the same rows: those named by the set are linearly dependent
  fewer,         ///< the set has fewer elements than {{number}}
  more,          ///< or more
  includes,      ///< the set has every element of the only row
  lacks,         ///< the set lacks an element of the only row
  touches,       ///< the set has an element of the only row
  quotient,      ///< the first field divided by the second is {{number}}
  within,        ///< every field is a whole number from {{least, most}}
  outside,       ///< some field is not
};

/// A decidable condition on an answer. `fields` are positions; empty: all fields.
struct Condition {
  Test test = Test::values;
  std::vector<int> fields = {};
  std::vector<std::vector<std::string>> values = {};
  friend bool operator==(const Condition&, const Condition&) = default;
};

/// A mistake recognised by its answer: it was made if all of `when` hold and the answer is not accepted.
struct Mistake {
  std::string name;  ///< of mistake_names.h
  std::vector<Condition> when;
  std::vector<int> fields = {};          ///< that are wrong; empty: the answer as a whole
  std::vector<ElementId> elements = {};  ///< that are highlighted in the drawing
  std::string reason;                    ///< one sentence: what was done, then what is right
  friend bool operator==(const Mistake&, const Mistake&) = default;
};

/// Headings of fields that are laid out as a table, row by row. Without columns the fields form a list.
struct AnswerTable {
  std::vector<std::string> rows = {};
  std::vector<std::string> columns = {};
  std::optional<int> partition = {};  ///< the first column right of the dashed line
  friend bool operator==(const AnswerTable&, const AnswerTable&) = default;
};

/// A question with its key, as data: texts, fields, accepted answers and known mistakes. An immutable value;
/// all graders that implement the tests agree on every answer.
struct Question {
  std::string kind;          ///< "cycle-basis": the name on the command line
  std::string prompt;        ///< sentences, with formulas in TeX between dollar signs
  std::string formula = {};  ///< in TeX, on a line of its own; may be empty
  AnswerTable table = {};
  std::vector<AnswerField> fields;
  int points = 1;
  std::vector<ElementId> elements = {};  ///< that the question is about
  CommaUse comma = CommaUse::ambiguous;  ///< in the language of the question

  // The key.
  std::vector<Condition> accepted;    ///< an answer is right if all hold
  std::vector<std::string> solution;  ///< one right answer
  std::string rule;                   ///< the reason for it in a sentence
  std::vector<Mistake> mistakes;      ///< the first one that holds is reported
  NumberSymbols symbols = {};         ///< in which numbers may be written

  friend bool operator==(const Question&, const Question&) = default;
};

}  // namespace geargraph
