#pragma once

#include <QByteArray>
#include <QList>

namespace geargraph::test {

/// The streams of a PDF, inflated, in the file's order: what pages paint, and, from cairo 1.18 on, the
/// objects that older releases write as such.
inline QList<QByteArray> pdfStreams(const QByteArray& pdf) {
  QList<QByteArray> streams;
  for (qsizetype at = pdf.indexOf("stream\n"); at >= 0; at = pdf.indexOf("stream\n", at)) {
    at += 7;
    const qsizetype end = pdf.indexOf("endstream", at);
    // qUncompress wants to be told a size first; it grows as needed.
    streams += qUncompress(QByteArray("\0\1\0\0", 4) + pdf.mid(at, end - at));
    at = end + 9;
  }
  return streams;
}

/// All that a PDF holds as text: its own bytes, and its streams.
inline QByteArray pdfText(const QByteArray& pdf) {
  return pdf + '\n' + pdfStreams(pdf).join('\n');
}

}  // namespace geargraph::test
