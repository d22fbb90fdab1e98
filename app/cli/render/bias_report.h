#pragma once
/// JSON forms of biases.

#include <QJsonArray>
#include <QJsonObject>

#include <vector>

#include "render/accuracy/bias.h"

namespace pdr::app {

/// Returns an object with value, low and high.
QJsonObject intervalObject(const Between& between);
/// Returns an array of objects with cause, ofComputing, text, brightness and levels (intervals), levelsAtMost and
/// shareAtMost. The last four are null where not known.
QJsonArray biasArray(const std::vector<Bias>& biases);

}  // namespace pdr::app
