#pragma once
/// Command `pdrender-cli example FOLDER [--cranium MATRIX.DAT]`: writes a CT series for trying out the program.

#include <QStringList>

namespace pdr::app {

/// Writes a DICOM CT series into FOLDER (new or empty): the head that InVesalius ships (MATRIX.DAT out of
/// Cranium.inv3), or without it an analytic head phantom. `arguments` come after the word "example". Progress and
/// errors go to stderr. Returns 0, 1 on an error, 2 on wrong usage.
int runExample(const QStringList& arguments);

}  // namespace pdr::app
