#pragma once
/// Messages of the libraries that do not use Qt, in the language of the window.

#include <QString>

#include "render/base/text.h"

namespace pdr::ui {

/// Returns `text` in the window's language: pattern and arguments are translated, numbers localised. Without a
/// translation it stays English.
QString inWords(const Text& text);

/// Returns the translated text as a sentence: with a capital at the beginning (unless it begins with a file's name) and
/// a full stop.
QString sentence(const Text& text);

}  // namespace pdr::ui
