#pragma once
/// The menu of windows for slices: the presets, the files' own window and the whole range, each with the digit that
/// chooses it on a slice.

#include <QMenu>
#include <functional>

#include "render/slice/grey_window.h"

namespace pdr::app {

/// Adds the entries to `menu`. A preset calls `choose` with its window; the other two call `chooseKey` with their
/// digit, since what they stand for depends on the scan.
void fillWindowMenu(QMenu& menu, const std::function<void(const GreyWindow&)>& choose,
                    const std::function<void(char)>& chooseKey);

}  // namespace pdr::app
