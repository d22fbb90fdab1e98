#pragma once
/// The request for an image to be saved, and the defaults and cost that the dialog offers.

#include <QSize>
#include <QString>
#include <optional>

#include "render/accuracy/stop_rule.h"
#include "ui/annotation/annotations.h"

namespace pdr::ui {

struct ImageOrder {
    QString file;               ///< ".png" or ".exr"
    std::optional<QSize> size;  ///< pixels; none: the image on the screen, as it is
    StopRule stop;              ///< when rendering an image of that size stops
    Annotate annotate = Annotate::sides;
};

/// The cost of rendering an image anew. Its error falls with the square root of the time, so one number is enough.
struct ImageCost {
    double secondsPerPixel = 0;  ///< rendering time until 95 % of the tissue is within 1 level; > 0

    /// Returns the time until an image of that size is within `levels` [s].
    double secondsUntil(double levels, QSize size) const {
        return secondsPerPixel * size.width() * size.height() / (levels * levels);
    }
};

/// The initial values of the dialog.
struct ImageOffer {
    QSize view;                     ///< size of the image on the screen [pixels]
    QString name;                   ///< file name without its suffix
    QString folder;                 ///< empty: the user's documents folder
    std::optional<ImageCost> cost;  ///< none: not known yet
    Annotate annotate = Annotate::sides;
    bool patientKnown = false;  ///< the patient's identity may be written on the image
};

}  // namespace pdr::ui
