#pragma once
/// A look that an option names.

#include <QString>

#include "render/scene/named_look.h"

namespace pdr::app {

/// Returns the bundled look called `text`, in capital or small letters, or the one in the file of that path. Throws an
/// Error, a usage error that names `option` where there is no such look.
NamedLook namedLook(const QString& text, const char* option);

}  // namespace pdr::app
