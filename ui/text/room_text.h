#pragma once
/// Sentences of the rooms below in the language of the window.

#include <QString>

#include "render/base/text.h"

namespace pdr::ui {

/// `text` as the window's language has it: pattern translated, arguments likewise, numbers written as people do. What
/// has no translation stays English.
QString inWords(const Text& text);

/// The same as a sentence: a capital in front (unless a file's name stands there), a full stop behind.
QString sentence(const Text& text);

}  // namespace pdr::ui
