#pragma once
/// Texts (render/base/text.h) with their patterns as lines, so that the receiver can say them in the language of its
/// window.

#include <string>

#include "render/base/text.h"

namespace pdr::wire {

/// What `text` was made of, as JSON: ["%1 and %2", "a.dcm", {"number": "0.5"}], {"sentence": [...]}. Empty for words,
/// which are the same in every language.
std::string partsOf(const Text& text);

/// The Text of these parts, unless they say anything else than `english`, which the receiver believes: then its words.
/// `parts`: from anybody; nothing longer than `english` is ever built from them.
Text textOf(const std::string& english, const std::string& parts);

}  // namespace pdr::wire
