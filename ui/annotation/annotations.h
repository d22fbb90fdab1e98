#pragma once
/// What is written over an image, so that it can be read wherever it goes: the patient's sides, an orientation cube, a
/// scale bar, what is shown and how, and that it is not for diagnostic use. One painter for the screen, for files, the
/// clipboard and the command line; it needs Qt's fonts (QGuiApplication) and no widget.

#include <QPainter>
#include <QStringList>
#include <cstdint>
#include <vector>

#include "render/scene/camera.h"

namespace pdr::ui {

/// What an image carries that leaves the program. Files of radiance (OpenEXR) carry nothing.
enum class Annotate {
    none,    ///< its pixels alone
    sides,   ///< all but who the patient is
    patient  ///< that as well
};

/// The annotations of one image.
struct Annotations {
    Camera camera;        ///< of the image: letters, cube and scale bar are its own
    QStringList patient;  ///< upper left, a line each; empty: nobody is named
    QStringList texts;    ///< lower left, a line each: look, part, cut, how far the image is
};

/// Paints them over an image that fills `size` from (0, 0), in letters of the painter's font. The last line in the
/// lower left is always "Not for diagnostic use". Where `size` has no room for texts (less than 12 lines of them) the
/// letters of the sides stand alone, and below 4 lines nothing.
void paintAnnotations(QPainter& painter, const Annotations& annotations, const QSize& size);

/// Paints them over pixels of 4 bytes each, row by row from the top, in letters that suit `size`. Any thread's.
void annotate(const Annotations& annotations, ivec2 size, std::vector<std::uint8_t>& rgba);

}  // namespace pdr::ui
