#pragma once
/// Command `pdrender-cli parts SCAN ...`: lists the parts of the patient that a label map marks in a scan, with their
/// volumes, or says why the map does not belong to the scan.

#include <QStringList>

namespace pdr::app {

/// Runs the command with `arguments`, those after the word "parts". Prints results to stdout, progress and errors to
/// stderr; never a patient's name. Returns 0, 1 on an error, 2 on wrong usage.
int runParts(const QStringList& arguments);

}  // namespace pdr::app
