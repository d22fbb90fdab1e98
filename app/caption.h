#pragma once
/// The words in a picture that leaves the window.

#include <QString>

#include "render/film/image_file.h"
#include "render/session/session.h"

namespace pdr::app {

/// `text` on one line, in letters that suit a picture of `size` pixels and are never wider than it. Any thread's.
Caption captionOf(const QString& text, ivec2 size);

/// What a picture alone says of itself while it is not as good as was wanted; nothing where that is not `captioned`.
QString captionOn(const Frame& frame, bool captioned);

}  // namespace pdr::app
