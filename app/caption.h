#pragma once
/// The words in a saved picture.

#include <QString>

#include "render/film/image_file.h"

namespace pdr::app {

/// `text` on one line, in letters that suit a picture of `size` pixels and are never wider than it. Any thread's.
Caption captionOf(const QString& text, ivec2 size);

}  // namespace pdr::app
