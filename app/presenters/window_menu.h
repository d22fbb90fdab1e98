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

/// Offers the presets in `menu`, or says there why they are not.
void offerPresets(const QMenu& menu, bool offered);

/// Returns the sentence why presets, which are in HU, are not offered for a scan.
QString whyNoPresets();

}  // namespace pdr::app
