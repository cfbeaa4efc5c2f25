#pragma once

#include "ui/document/document.h"

namespace geargraph {

class Workbench;

/// Everything derived from the document (results, speeds, motion, 3D) shows the document after an edit, until
/// Workbench::request(), which every change of the document calls. The document itself, its history and its
/// drawings do not change. Returns why the edit is rejected, and then asks for the document itself; empty if
/// it is shown.
Diagnostics showTrial(Workbench& workbench, const Edit& edit);

}  // namespace geargraph
