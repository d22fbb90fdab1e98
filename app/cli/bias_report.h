#pragma once
/// Bias as JSON.

#include <QJsonArray>
#include <QJsonObject>

#include <vector>

#include "render/accuracy/bias.h"

namespace pdr::app {

/// value, low, high
QJsonObject intervalObject(const Between& between);
/// Each with cause, ofComputing, text; brightness and levels as intervals, levelsAtMost, shareAtMost: null where not
/// known.
QJsonArray biasArray(const std::vector<Bias>& biases);

}  // namespace pdr::app
