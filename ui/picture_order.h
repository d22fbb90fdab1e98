#pragma once
/// What is wanted of a picture that is to be saved.

#include <QSize>
#include <QString>
#include <optional>

#include "render/accuracy/stop_rule.h"

namespace pdr::ui {

struct PictureOrder {
    QString file;               ///< ".png" or ".exr"
    std::optional<QSize> size;  ///< pixels; none: what is on the screen, as it is
    StopRule stop;              ///< when a picture of that size is good enough
};

}  // namespace pdr::ui
