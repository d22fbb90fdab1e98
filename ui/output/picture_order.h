#pragma once
/// What is wanted of a picture that is to be saved, and what there is to choose from.

#include <QSize>
#include <QString>
#include <optional>

#include "render/accuracy/stop_rule.h"
#include "ui/annotation/annotations.h"

namespace pdr::ui {

struct PictureOrder {
    QString file;               ///< ".png" or ".exr"
    std::optional<QSize> size;  ///< pixels; none: what is on the screen, as it is
    StopRule stop;              ///< when a picture of that size is good enough
    Annotate annotate = Annotate::sides;
};

/// What a picture costs to make anew. Its error falls with the square root of the time, so one number tells all.
struct PictureCost {
    double secondsPerPixel = 0;  ///< of rendering, until 95 % of the tissue is within 1 level; > 0

    /// Until a picture of that size is within so many levels [s].
    double secondsUntil(double levels, QSize size) const {
        return secondsPerPixel * size.width() * size.height() / (levels * levels);
    }
};

/// What the dialog begins with.
struct PictureOffer {
    QSize view;                       ///< on the screen [pixels]
    QString name;                     ///< of the file, without its end
    QString folder;                   ///< empty: where documents are
    std::optional<PictureCost> cost;  ///< none: not known yet
    Annotate annotate = Annotate::sides;
    bool patientKnown = false;  ///< who it is may be written into the picture
};

}  // namespace pdr::ui
