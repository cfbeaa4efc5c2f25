#pragma once

#include <string>

#include "core/mechanism/graph/integer_matrix.h"

namespace geargraph {

// A matrix as text for other programs. All carry the labels: as a header row and column (TSV, LaTeX) or in a
// comment (MATLAB, NumPy). The partition is a vertical rule in LaTeX and is left out elsewhere.
// Cost: O(rows · columns).

/// Tab-separated, for the clipboard of spreadsheet programs; the first cell is the matrix's symbol.
[[nodiscard]] std::string matrixTsv(const IntegerMatrix& matrix);

/// Comma-separated, for the clipboard; files are written by matrix_csv.h (files). No label needs quotes.
[[nodiscard]] std::string matrixCsv(const IntegerMatrix& matrix);

/// An array environment, for math mode; needs no package.
[[nodiscard]] std::string matrixLatex(const IntegerMatrix& matrix);

/// An assignment for MATLAB and Octave.
[[nodiscard]] std::string matrixMatlab(const IntegerMatrix& matrix);

/// An assignment for Python, with numpy imported as np.
[[nodiscard]] std::string matrixNumpy(const IntegerMatrix& matrix);

/// The name of the matrix as an ASCII identifier: Gamma0, Gamma, Z, T, C, Q.
[[nodiscard]] std::string matrixAsciiName(MatrixKind kind);

}  // namespace geargraph
