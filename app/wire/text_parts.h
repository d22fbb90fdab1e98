#pragma once
/// Serializes texts (render/base/text.h) with their patterns, so that the receiver can show them in the language of its
/// window.

#include <string>

#include "render/base/text.h"

namespace pdr::wire {

/// Returns the parts of `text` as JSON: ["%1 and %2", "a.dcm", {"number": "0.5"}], {"sentence": [...]}. Empty for
/// plain words, which are the same in every language.
std::string partsOf(const Text& text);

/// Returns the Text of these parts if it reads as `english` in English; otherwise `english` as plain words. `parts` may
/// come from an untrusted peer; nothing longer than `english` is ever built from them.
Text textOf(const std::string& english, const std::string& parts);

}  // namespace pdr::wire
