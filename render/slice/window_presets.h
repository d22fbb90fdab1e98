#pragma once
/// Windows that fit tissues, and the one that fits a volume.

#include <span>

#include "render/slice/grey_window.h"
#include "render/volume/volume.h"

namespace pdr {

/// A window with a name. Presets of one key follow each other: pressing it again takes the next.
struct WindowPreset {
    char key;          ///< digit that chooses it
    const char* name;  ///< in English, small letters: "soft tissue"
    GreyWindow window;
};

/// Returns the presets in the order of their keys, 1 to 8. The keys 9 and 0 stand for the file's own window and for
/// wholeRange(), which differ from scan to scan.
std::span<const WindowPreset> windowPresets();

/// Returns the window from black at the 0.1 % of the measured voxels with the lowest HU to white at the 0.1 % with the
/// highest, at least 1 HU wide.
GreyWindow wholeRange(const Volume& volume);

}  // namespace pdr
