#pragma once

#include <cstdint>
#include <string>

#include "core/foundations/files/byte_sink.h"
#include "core/teaching/derivation/result_table.h"

namespace geargraph {

class JsonWriter;
struct CsvOptions;

// A result as text for people and other programs, in every form there is. All carry the labels: as a header
// row and column (TSV, CSV, LaTeX) or in a comment (MATLAB, NumPy). The partition is a vertical rule in LaTeX
// and in the grid, and is left out elsewhere. Cost: O(rows · columns).

enum class TableFormat : std::uint8_t {
  tsv,     ///< tab-separated, for the clipboard of spreadsheet programs
  csv,     ///< comma-separated, for the clipboard; no label needs quotes
  latex,   ///< an array environment, for math mode; needs no package
  matlab,  ///< an assignment for MATLAB and Octave
  numpy,   ///< an assignment for Python, with numpy imported as np
};

/// Symbols as formulas, decimals with as many digits as read back as the same number.
[[nodiscard]] std::string resultText(const ResultTable& table, TableFormat format);

/// LaTeX for people: about six digits in place of a long fraction.
[[nodiscard]] std::string readableLatex(const ResultTable& table);

enum class CsvEntries : std::uint8_t {
  decimals,  ///< numbers, for programs
  asShown,  ///< as fractions or symbols where the table is of these; the decimal point does not apply to them
};
/// A CSV file row by row, until the sink fails. Texts that contain the separator are quoted.
void writeResultCsv(ByteSink& sink, const ResultTable& table, const CsvOptions& options,
                    CsvEntries entries = CsvEntries::decimals);

/// {"rows", "columns": labels, "entries": row by row}, or with "triplets" of the non-zeros: row, column,
/// value.
void writeResultJson(JsonWriter& json, const ResultTable& table, bool asTriplets);

/// Rows and columns under their labels, zeros as dots, a bar where the table is parted.
[[nodiscard]] std::string resultGrid(const ResultTable& table);

}  // namespace geargraph
